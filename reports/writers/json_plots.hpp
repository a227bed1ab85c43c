// SPDX-License-Identifier: Apache-2.0
// The JSON of a plot's description. Included by writers only.
#pragma once

#include "reports/model/plots.hpp"
#include "reports/writers/json_values.hpp"

namespace polhode::report {

/// What a plot does not have is left out.
json to_value(const plot_description&);

}  // namespace polhode::report
