// SPDX-License-Identifier: Apache-2.0
// What plots are called, and what is said below them.
#pragma once

#include <initializer_list>
#include <string>

#include "reports/model/results.hpp"
#include "reports/plots/findings.hpp"

namespace polhode::report {

/// "error of energy [1/time]"; the unit "1" is none.
std::string title_of(const measurement&);
/// "|error of energy| [1/time]"
std::string absolute_title_of(const measurement&);
std::string with_unit(const std::string& text, const std::string& unit);

/// "2 values are missing: not finite."; empty where none is.
std::string missing_in(const row_list&);

/// A name that can stand in an address: "weak.error.exp-pi3". Empty parts are left out.
std::string slug(std::initializer_list<std::string> parts);

}  // namespace polhode::report
