// SPDX-License-Identifier: Apache-2.0
// Where a scheme from elsewhere comes from, as text.
#pragma once

#include <string>

#include "reports/model/results.hpp"

namespace polhode::report {

/// "my_heun: through library my_heun.so, takes increments; measured, as not claimed: weak_general = 1"; empty for ours.
std::string origin_of(const scheme&);

}  // namespace polhode::report
