// SPDX-License-Identifier: Apache-2.0
// Point vortices on the unit sphere, of strengths Gamma_i of either sign, on the dual of so(3)^N.
//
//   dx_i/dt = 1/(4 pi) sum_{j != i} Gamma_j x_j x x_i / (1 - x_i.x_j)                  (without dissipation and noise),
//   h = -1/(4 pi) sum_{i<j} Gamma_i Gamma_j log(1 - x_i.x_j)                            (their part of the kinetic
//   energy)
//
// The state is mu_i = -Gamma_i x_i: with that sign the equation is dmu_i/dt = mu_i x dh/dmu_i, that of spins.hpp, with
// its dissipation and noise. The Casimirs are |mu_i| = |Gamma_i|. Without dissipation and noise h and sum mu_i are
// kept. Dissipation drives vortices of one sign apart, and of both signs together: in a finite time they meet, where
// the equation ends. Source: Bogomolov, Fluid Dyn. 12 (1977) 863-870; Polvani, Dritschel, J. Fluid Mech. 255 (1993)
// 35-64; Newton, The N-Vortex Problem (2001), ch. 4.
#pragma once

#include <utility>
#include <vector>

#include <polhode/systems/spins.hpp>

namespace polhode {

inline constexpr int most_vortices = most_spins;

/// 1 to 16 strengths, none zero; theta >= 0; noise of 3 N components.
inline spins vortices(const std::vector<double>& strengths, double dissipation,
                      constant_noise<spins::group> noise_vectors) {
  std::vector<pair_energy> pairs;
  for (std::size_t i = 0; i < strengths.size(); ++i)
    for (std::size_t j = i + 1; j < strengths.size(); ++j)
      pairs.push_back(pair_energy::of_vortices(static_cast<int>(i), static_cast<int>(j), strengths[i], strengths[j]));
  return {std::move(pairs), dissipation, std::move(noise_vectors)};
}

}  // namespace polhode
