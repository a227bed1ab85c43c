// SPDX-License-Identifier: Apache-2.0
// Weak errors combined over step sizes so that leading powers of dt drop out (Talay, Tubaro, Stoch. Anal. Appl. 8
// (1990) 483), and what an accuracy then costs.
//
// The palindrome strang_two_turns has no odd power of dt of its own, but its noise step has: with u = sigma^2 dt the
// scaled Gaussian rotation multiplies harmonics of degree one by exp(-u + u^4/864 + ...), which leaves a small dt^3.
// Without dt^2 the order so is three, dt^4 being seen first; without dt^2, dt^3 and dt^4 it is five, dt^6 being seen
// first.
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/laws/transfer_report.hpp"

namespace polhode {

struct extrapolation {
  std::string_view name;
  std::span<const int> powers;  ///< of dt that drop out, one more level each
  double order;                 ///< what is left

  /// Steps of all runs together for one step of the coarsest: 1 + 2 + 4 + ….
  double runs() const { return std::exp2(static_cast<double>(levels())) - 1; }
  /// Step sizes that are combined.
  int levels() const { return static_cast<int>(powers.size()) + 1; }
};

inline constexpr std::string_view extrapolated_from = "strang_two_turns";
inline constexpr std::array dropped_powers{2, 3, 4};
inline constexpr std::array extrapolations{extrapolation{"strang_extrapolated", std::span(dropped_powers).first(1), 3},
                                           extrapolation{"strang_extrapolated5", dropped_powers, 5}};

/// {name, extrapolated_from} of each: experiment::derived_names.
std::vector<std::pair<std::string, std::string>> extrapolated_names();

/// E(dt), E(dt/2), …: for each power p in turn (2^p E(dt/2) - E(dt)) / (2^p - 1). Listed by the coarsest dt.
error_table extrapolate(const error_table&, const extrapolation&);

/// Steps of one path over the horizon, all runs of a combination together, for every error to be at most `accuracy` of
/// its scale: between measured levels a power law, beyond them the claimed order. runs: steps per step of the coarsest.
double steps_for(const error_table&, std::span<const error_column>, double horizon, double accuracy, double order,
                 double runs);

}  // namespace polhode
