// SPDX-License-Identifier: Apache-2.0
// The energy law of every system with dissipation: dh/dt = -theta |ad*_{grad h} mu|^2 along its drift.
#include <gtest/gtest.h>

#include <cmath>

#include <polhode/systems/double_bracket.hpp>
#include <polhode/systems/maxwell_bloch.hpp>
#include <polhode/systems/rigid_body.hpp>
#include <polhode/systems/sine_euler.hpp>
#include <polhode/systems/so4_body.hpp>
#include <polhode/systems/son_body.hpp>
#include <polhode/systems/spins.hpp>
#include <polhode/systems/vortices.hpp>

#include "support/heavy_top.hpp"
#include "support/spin.hpp"

namespace polhode::test {
namespace {

/// Calls with(system, mu, step, within) for each system at that theta: a central difference of its energy over that
/// step is its slope to `within`, whatever the step where it is of second degree.
template <class With>
void over_systems(double theta, With with) {
  const vec<double, 3> three{{0.6, 0.48, 0.64}};
  const vec<double, 6> six{{0.5, -0.3, 0.7, 0.48, 0.6, 0.64}};
  const auto of_size = [&]<class Vector>(Vector out) {
    for (int k = 0; k < out.size; ++k) {
      const int round = k / 6;
      out[k] = six[k % 6] + 0.1 * round;
    }
    return out;
  };
  const auto nine = of_size(vec<double, spins::group::dimension>(9));
  Eigen::Matrix3d exchange;
  exchange << 0, 0.3, -0.2, 0.3, 0, 0.5, -0.2, 0.5, 0;
  const Eigen::Matrix3d easy_axis = Eigen::Vector3d(0.2, -0.4, 1).asDiagonal();
  with(rigid_body({1, 2, 3}, theta, rigid_body::isotropic(0.3)), three, 0x1p-3, 1e-14);
  with(tilted_spin(theta), three, 0x1p-3, 1e-14);
  with(maxwell_bloch(theta, maxwell_bloch::isotropic(0.3)), three, 0x1p-3, 1e-14);
  with(asymmetric_top(theta), six, 0x1p-3, 1e-14);
  with(so4_body({1, 2, 3, 1.5, 2.5, 0.7}, 0.3, theta, so4_body::isotropic(0.3)), six, 0x1p-3, 1e-14);
  with(son_body({1, 2, 3, 5}, theta, son_body::isotropic(0.3, 6)), of_size(vec<double, son::dimension>(6)), 0x1p-3,
       1e-14);
  with(sine_euler(5, theta, sine_euler::isotropic(0.3, 24)), of_size(vec<double, su::dimension>(24)), 0x1p-3, 1e-12);
  with(spins(easy_axis, {0.3, -0.2, 0.5}, exchange, theta, spins::isotropic(0.3, 9)), nine, 0x1p-3, 1e-14);
  with(vortices({1, -0.5, 0.7}, theta, spins::isotropic(0.3, 9)), nine, 1e-4, 1e-8);
}

TEST(EnergyDecay, IsTheDoubleBracketsOfEverySystem) {
  for (const double theta : {0.4, 1.0})
    over_systems(theta, [&]<class System>(const System& system, const auto& mu, double step, double within) {
      const auto drift = System::algebra::coad(system.generator(mu), mu);
      const double slope = (system.energy(mu + step * drift) - system.energy(mu - step * drift)) / (2 * step);
      const auto turned = System::algebra::coad(system.omega(mu), mu);
      const double square = dot(turned, turned);
      EXPECT_NEAR(slope, -theta * square, within) << theta;
      EXPECT_NEAR(system.dissipation_rate(mu), theta * square, 1e-14 * (1 + square)) << theta;
      EXPECT_GT(square, 0.001);
    });
}

// The flow of the dissipation alone loses what the law says, and without dissipation nothing moves.
TEST(EnergyDecay, IsThatOfTheDissipationsFlow) {
  for (const double theta : {0.0, 0.4, 1.0})
    over_systems(theta, [&]<class System>(const System& system, const auto& mu, double, double) {
      if constexpr (requires { system.dissipation_flow(mu, 0.1); }) {
        const double t = 1e-4, lost = system.energy(mu) - system.energy(system.dissipation_flow(mu, t));
        EXPECT_NEAR(lost / t, system.dissipation_rate(mu), 1e-3 * system.dissipation_rate(mu)) << theta;
      }
    });
}

}  // namespace
}  // namespace polhode::test
