// SPDX-License-Identifier: Apache-2.0
// Flows of the dissipation alone at coefficients of one: energy falls at the rate of the double bracket. And of states
// of nothing, in whole or in part, which have no direction.
#include <gtest/gtest.h>

#include <cmath>

#include <polhode/systems/heavy_top.hpp>
#include <polhode/systems/maxwell_bloch.hpp>
#include <polhode/systems/rigid_body.hpp>
#include <polhode/systems/sine_euler.hpp>
#include <polhode/systems/so4_body.hpp>
#include <polhode/systems/son_body.hpp>
#include <polhode/systems/spin.hpp>
#include <polhode/systems/spins.hpp>

#include "support/expect_near.hpp"

namespace polhode {
namespace {

template <class Vector>
Vector some(int n) {
  auto out = zeros<Vector>(n);
  for (int k = 0; k < n; ++k) out[k] = 0.6 * std::sin(1.7 * k + 0.4);
  return out;
}
using test::expect_near;

const Eigen::Matrix3d quadratic{{0.6, 0.1, -0.2}, {0.1, -0.3, 0.15}, {-0.2, 0.15, -1.2}};

/// dh/dt = -theta |ad*_Omega mu|^2, by the difference of two short flows, forward and back.
template <class System>
[[gnu::noinline]] void expect_rate(const System& system, int n) {
  using g = typename System::algebra;
  constexpr double t = 1e-4;
  const auto mu = some<vec<double, System::dimension>>(n);
  const auto turning = g::coad(system.omega(mu), mu);
  const double rate =
      (system.energy(system.dissipation_flow(mu, -t)) - system.energy(system.dissipation_flow(mu, t))) / (2 * t);
  EXPECT_NEAR(rate / (system.theta * dot(turning, turning)), 1, 1e-6);
}

TEST(DissipationFlow, TakesEnergyAtItsRateOfAnyCoefficient) {
  for (const double theta : {0.4, 1.0}) {
    const spin site(quadratic, {0.3, -0.2, 0.5}, theta, constant_noise<so3>());
    expect_rate(site, 3);
    expect_rate(spin(quadratic, {0, 0, 0}, theta, constant_noise<so3>()), 3);
    expect_rate(rigid_body({1, 2, 3}, theta, constant_noise<so3>()), 3);
    expect_rate(maxwell_bloch(theta, constant_noise<se2>()), 3);
    expect_rate(heavy_top({1, 1.5, 2.2}, 0.8, {0.3, -0.4, 0.6}, theta, constant_noise<se3>()), 6);
    for (const double coupling : {0.3, 1.0})
      expect_rate(so4_body({1, 2, 3, 1.25, 2.5, 1.6}, coupling, theta, constant_noise<so4>()), 6);
    expect_rate(son_body({0.5, 0.8, 1.1, 1.7}, theta, constant_noise<son>::isotropic(0, 6)), 6);
    expect_rate(sine_euler(3, theta, constant_noise<su>::isotropic(0, 8)), 8);
    const Eigen::Matrix3d exchange{{0, 0.3, -0.4}, {0.3, 0, 0.5}, {-0.4, 0.5, 0}};
    expect_rate(spins(quadratic, {0.3, -0.2, 0.5}, exchange, theta, constant_noise<spins::group>::isotropic(0, 9)), 9);
  }
}

TEST(DissipationFlow, OfAStateOfNothingIsItself) {
  expect_near(rigid_body({1, 2, 3}, 0.4, constant_noise<so3>()).dissipation_flow(vec<double, 3>{}, 0.1), {}, 0);
  for (const Eigen::Matrix3d& of : {quadratic, Eigen::Matrix3d(Eigen::Matrix3d::Zero())})
    expect_near(spin(of, {0.3, -0.2, 0.5}, 0.4, constant_noise<so3>()).dissipation_flow(vec<double, 3>{}, 0.1), {}, 0);
  const so4_body pair({1, 2, 3, 1.25, 2.5, 1.6}, 0.3, 0.4, constant_noise<so4>());
  expect_near(pair.dissipation_flow(vec<double, 6>{}, 0.1), {}, 0);
}

// The coupling has nothing to turn: each body is by itself.
TEST(DissipationFlow, OfABodyBesideOneAtRestIsItsOwn) {
  const so4_body pair({1, 2, 3, 1.25, 2.5, 1.6}, 0.3, 0.4, constant_noise<so4>());
  const vec<double, 3> mu{{0.3, -0.7, 1.1}};
  const auto first = rigid_body({1, 2, 3}, 0.4, constant_noise<so3>()).dissipation_flow(mu, 0.2),
             second = rigid_body({1.25, 2.5, 1.6}, 0.4, constant_noise<so3>()).dissipation_flow(mu, 0.2);
  expect_near(pair.dissipation_flow(so4::joined(mu, {}), 0.2), so4::joined(first, {}), 1e-15);
  expect_near(pair.dissipation_flow(so4::joined({}, mu), 0.2), so4::joined({}, second), 1e-15);
}

// dmu/dt = ad*_{c (b, a)} (a, b), by the difference of two short flows.
TEST(FirstTurn, OfCoupledBodiesIsTheCouplingOfAnyStrength) {
  constexpr double t = 1e-4;
  const auto mu = some<vec<double, 6>>(6);
  const auto a = so4::part(mu, 0), b = so4::part(mu, 1);
  for (const double coupling : {0.3, 1.0}) {
    const so4_body pair({1, 2, 3, 1.25, 2.5, 1.6}, coupling, 0, constant_noise<so4>());
    const auto change = (0.5 / t) * (pair.first_turn(mu, t) - pair.first_turn(mu, -t));
    expect_near(change, coupling * so4::joined(cross(a, b), cross(b, a)), 1e-8);
  }
}

}  // namespace
}  // namespace polhode
