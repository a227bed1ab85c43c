// SPDX-License-Identifier: Apache-2.0
// What every door holds of a description that it is given.
#pragma once

#include <string>

#include "foreign/integrator.hpp"

namespace polhode::foreign {

/// The description. Throws input_error, which begins with `where`: a name or an order that is not accepted.
description checked(description, const std::string& where);

}  // namespace polhode::foreign
