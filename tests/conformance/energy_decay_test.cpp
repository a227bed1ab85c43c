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

constexpr double theta = 0.4;

/// Energies of second degree have their central difference, whatever its step, as their slope; others by `within`.
template <class System, int N>
void expect_energy_law(const System& system, const vec<double, N>& mu, double step = 0x1p-3, double within = 1e-14) {
  const auto drift = System::algebra::coad(system.generator(mu), mu);
  const double slope = (system.energy(mu + step * drift) - system.energy(mu - step * drift)) / (2 * step);
  const auto turned = System::algebra::coad(system.omega(mu), mu);
  const double square = dot(turned, turned);
  EXPECT_NEAR(slope, -theta * square, within);
  EXPECT_NEAR(system.dissipation_rate(mu), theta * square, 1e-14);
  EXPECT_GT(square, 0.001);
}

TEST(EnergyDecay, IsTheDoubleBracketsOfEverySystem) {
  const vec<double, 3> three{{0.6, 0.48, 0.64}};
  const vec<double, 6> six{{0.5, -0.3, 0.7, 0.48, 0.6, 0.64}};
  expect_energy_law(rigid_body({1, 2, 3}, theta, rigid_body::isotropic(0.3)), three);
  expect_energy_law(tilted_spin(theta), three);
  expect_energy_law(maxwell_bloch(theta, maxwell_bloch::isotropic(0.3)), three);
  expect_energy_law(asymmetric_top(theta), six);
  expect_energy_law(so4_body({1, 2, 3, 1.5, 2.5, 0.7}, 0.3, theta, so4_body::isotropic(0.3)), six);
  const auto of_size = [&]<class Vector>(Vector out) {
    for (int k = 0; k < out.size; ++k) out[k] = k < 6 ? six[k] : six[k - 6] + 0.1;
    return out;
  };
  expect_energy_law(son_body({1, 2, 3, 5}, theta, son_body::isotropic(0.3, 6)),
                    of_size(vec<double, son::dimension>(6)));
  expect_energy_law(sine_euler(3, theta, sine_euler::isotropic(0.3, 8)), of_size(vec<double, su::dimension>(8)));
  const auto nine = of_size(vec<double, spins::group::dimension>(9));
  Eigen::Matrix3d exchange;
  exchange << 0, 0.3, -0.2, 0.3, 0, 0.5, -0.2, 0.5, 0;
  const Eigen::Matrix3d easy_axis = Eigen::Vector3d(0.2, -0.4, 1).asDiagonal();
  expect_energy_law(spins(easy_axis, {0.3, -0.2, 0.5}, exchange, theta, spins::isotropic(0.3, 9)), nine);
  expect_energy_law(vortices({1, -0.5, 0.7}, theta, spins::isotropic(0.3, 9)), nine, 1e-4, 1e-8);
}

}  // namespace
}  // namespace polhode::test
