// SPDX-License-Identifier: Apache-2.0
// What "broken" means of a path and of a run.
#pragma once

#include <string_view>

namespace polhode {

/// What can break, in the order in which it is asked.
enum class breakage { none, not_solved, not_finite, casimir, energy_range, mean_energy };
std::string_view name_of(breakage);

// A path: its numbers are not finite (an implicit step: not solved), |Pi| is off by more than
// casimir_share, or h lies outside what the sphere allows by more than energy_share of the greatest. A run: more than
// broken_share of its paths are broken, or their mean energy at the end is off by more than mean_energy_share of the
// range of h.
inline constexpr double casimir_share = 0.1, energy_share = 0.1, mean_energy_share = 0.05, broken_share = 0.01;

}  // namespace polhode
