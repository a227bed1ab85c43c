// SPDX-License-Identifier: Apache-2.0
// The explicit midpoint rule on the group, to be added to a copy of the tree.
#pragma once

#include <polhode/schemes/scheme_info.hpp>

namespace polhode {

struct toy_scheme {
  static constexpr scheme_info info{.name = "toy_scheme",
                                    .title = "Explicit midpoint on the group",
                                    .source = "docs/add-a-scheme.md",
                                    .calculus = calculus::stratonovich,
                                    .strong_order = {.commuting = 1, .general = 0.5},
                                    .weak_order = {.one_vector = 1, .isotropic = 1, .general = 1},
                                    .deterministic_order = 2,
                                    .casimir = keeps_casimirs,
                                    .action = group_action::exponential};

  template <lie_poisson_system System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    using g = typename System::algebra;
    const auto half = g::exp_action(S(0.5) * generator(system, mu, w), mu);
    return g::exp_action(generator(system, half, w), mu);
  }
};

}  // namespace polhode
