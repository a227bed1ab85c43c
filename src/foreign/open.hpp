// SPDX-License-Identifier: Apache-2.0
// Which door an argument of --with goes through.
#pragma once

#include <string>
#include <vector>

#include "foreign/foreign_scheme.hpp"

namespace polhode::foreign {

/// A library by its ending (.so, .dylib), else a command, whose answers may take `deadline` seconds. Throws
/// input_error.
foreign_schemes open_integrators(const std::string& given, double deadline);

}  // namespace polhode::foreign
