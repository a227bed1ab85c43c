// SPDX-License-Identifier: Apache-2.0
// Integrators in a shared library with the C interface of integrators/include/polhode/abi.h.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "foreign/integrator.hpp"

namespace polhode::foreign {

/// All that it offers; it stays loaded. Throws input_error: not a library, without the entry, of another version.
std::vector<std::unique_ptr<integrator>> open_library(const std::string& path);

}  // namespace polhode::foreign
