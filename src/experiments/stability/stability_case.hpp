// SPDX-License-Identifier: Apache-2.0
// The scenes on which a scheme is tried until it breaks: one parameter of the scene moved at a time, and the corners of
// the equation.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ensemble/kernel.hpp"
#include "experiments/common/experiment.hpp"
#include "experiments/common/recorder.hpp"

namespace polhode {

/// A scene, what its orbit keeps, and what it bounds.
struct stability_case {
  std::string name;                                ///< "scene", "separatrix", …; of one along an axis none
  std::optional<report::coordinate> changed = {};  ///< of one along an axis: its place there
  subject bound;
  double rate = 0;     ///< the fastest of its rates (experiments/common/levels.hpp)
  double horizon = 0;  ///< T: of the scene, but at least 64 of 1/rate and at most 128 … 1024
  std::vector<double> casimirs = {}, casimir_sizes = {};  ///< at the start; on a sphere |Pi| alone
  bool compact = true;                                    ///< |mu| is the same all over the orbit
  bool bounded = true;                                    ///< the range of h on the orbit is known: it is a sphere
  double least_energy = 0, greatest_energy = 0;  ///< of h there; elsewhere as far as the true paths are seen to go
  bool normal = true;                            ///< false: |Pi| below the range in which its square keeps all digits
  std::optional<double> mean_energy = {};        ///< E[h(Pi_T)]; absent where h is nearly the Casimir, or not known
  std::string mean_energy_method = {};           ///< exact or reference

  double energy_size() const { return std::max(std::fabs(least_energy), std::fabs(greatest_energy)); }
  double dt(std::int64_t steps) const { return horizon / static_cast<double>(steps); }
};

/// dt times the fastest rate: the longest that is tried, and that with which the search for the limit begins.
inline constexpr double longest_stable_step = 32, first_stable_step = 1.0 / 8;

/// Strengths of the dissipation, increasing: the axis of the map; where no dissipation moves anything none.
std::vector<double> stiffness_axis(const subject&, effort);

/// A row about one case, whose name is the observable, at its place along an axis.
report::measurement row_in(const stability_case&, quantity, std::optional<double> value);

/// Is told of the noise of one block after another, each from its step 0 on, and of the length of a step.
using block_listener = std::function<void(std::int64_t first_step, const increment_view&, double dt)>;

/// The scene first; their mean energies are not known yet.
std::vector<stability_case> stability_cases(const context&);

}  // namespace polhode
