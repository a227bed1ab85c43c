// SPDX-License-Identifier: Apache-2.0
// Spins: axes of their own, turns and their sums, noise that depends on the state, against the equation by hand.
#include <gtest/gtest.h>

#include <cmath>

#include <polhode/schemes/lie_milstein.hpp>
#include <polhode/systems/spins.hpp>
#include <polhode/systems/varying_spin.hpp>

#include "support/expect_near.hpp"

namespace polhode {
namespace {

using vector = vec<double, 3>;
const vector mu{{0.3, -0.7, 1.1}};
constexpr double t = 1e-4;

using test::expect_near;
/// At t = 0 of a flow, to t^2 of it.
template <class Flow>
vector rate_of(Flow flow) {
  return (0.5 / t) * (flow(t) - flow(-t));
}

TEST(PrincipalQuadratic, KnowsTheAxisThatIsNotLikeTheOthers) {
  EXPECT_EQ((principal_quadratic{{{3, 1, 1}}}).odd_axis(), 0);
  EXPECT_EQ((principal_quadratic{{{1, 3, 1}}}).odd_axis(), 1);
  EXPECT_EQ((principal_quadratic{{{1, 1, 3}}}).odd_axis(), 2);
  EXPECT_LT((principal_quadratic{{{1, 2, 3}}}).odd_axis(), 0);
}

// However small what is beside the diagonal, and whatever the signs of the eigenvectors that are found: of forty frames
// some are mirrored, and some are not but have a determinant that is rounded to less than one.
TEST(Spin, MovesByItsQuadraticInAnyAxes) {
  for (int i = 0; i < 40; ++i) {
    const auto number = [&](int k) { return std::sin(1.7 * i + 2.3 * k); };
    const double x = 0.3 * number(0), y = 0.2 * number(1), z = 0.1 * number(2);
    const Eigen::Matrix3d quadratic{{number(3), x, y}, {x, number(4), z}, {y, z, number(5)}};
    const spin s(quadratic, {0, 0, 0}, 0, constant_noise<so3>());
    const Eigen::Vector3d by_hand = quadratic * Eigen::Vector3d(mu[0], mu[1], mu[2]);
    const vector omega{{by_hand[0], by_hand[1], by_hand[2]}};
    EXPECT_FALSE(s.diagonal());
    expect_near(s.omega(mu), omega, 1e-15);
    EXPECT_NEAR(s.energy(mu), dot(mu, omega) / 2, 1e-15);
    expect_near(rate_of([&](double h) { return s.free_flow(mu, h); }), cross(mu, omega), 1e-7);
  }
}

/// The noise vectors: some, one of which may be zero.
Eigen::Matrix3d vectors(bool third) {
  Eigen::Matrix3d sigma{{0.4, -0.1, 0.3}, {0.2, 0.5, -0.2}, {-0.3, 0.1, 0.6}};
  if (!third) sigma.col(2).setZero();
  return sigma;
}
varying_spin varying(state_noise form, bool third = true) {
  const Eigen::Matrix3d quadratic = Eigen::Vector3d(0.6, -0.9, 1.4).asDiagonal();
  return {spin(quadratic, {0.3, -0.2, 0.5}, 0.7, constant_noise<so3>(vectors(third))), form};
}
/// V_i(pi) = pi x sigma_i(pi), by hand.
vector field(state_noise form, int i, const vector& pi, bool third = true) {
  const Eigen::Vector3d column = vectors(third).col(i);
  const vector v{{column[0], column[1], column[2]}};
  if (form == state_noise::damped) return cross(pi, v + 0.7 * cross(pi, v));
  return column.norm() > 0 ? cross(pi, dot(v, pi) / column.norm() * v) : vector{};
}
/// DV_i [V_i], by the difference of two neighbours.
vector twice(state_noise form, int i, const vector& pi) {
  const auto along = field(form, i, pi);
  return (0.5 / t) * (field(form, i, pi + t * along) - field(form, i, pi - t * along));
}
constexpr state_noise forms[] = {state_noise::damped, state_noise::quadratic};

TEST(VaryingSpin, HasTheDriftOfItsFields) {
  for (const auto form : forms)
    expect_near(varying(form).ito_drift(mu), 0.5 * (twice(form, 0, mu) + twice(form, 1, mu) + twice(form, 2, mu)),
                1e-8);
}

// To first order the sum of all fields; a vector of nothing moves nothing.
TEST(VaryingSpin, FlowsAlongItsFields) {
  for (const auto form : forms)
    for (const bool third : {true, false}) {
      const auto s = varying(form, third);
      const vector dw{{0.6, -0.5, 0.8}};
      const auto expected =
          dw[0] * field(form, 0, mu, third) + dw[1] * field(form, 1, mu, third) + dw[2] * field(form, 2, mu, third);
      expect_near(rate_of([&](double h) { return s.noise_flow(mu, wiener<double, 3>{0, h * dw}); }), expected, 1e-7);
      expect_near(so3::coad(s.noise_at(mu, wiener<double, 3>{0, dw}), mu), expected, 1e-15);
    }
}

// One vector after a time of none: (step(w) - 2 mu + step(-w)) / w^2 tends to DV[V].
TEST(LieMilstein, TurnsByHalfTheSlopeOfNoiseThatDependsOnTheState) {
  const double w = 1e-3;
  for (const auto form : forms)
    for (int i = 0; i < 3; ++i) {
      const auto step = [&](double by) {
        wiener_levy<double, 3> increment;
        increment.dw[i] = by;
        return lie_milstein::step(varying(form), mu, increment);
      };
      expect_near((1 / (w * w)) * (step(w) - mu + (step(-w) - mu)), twice(form, i, mu), 2e-6);
    }
}

// What stood in the places of a third spin is none of theirs.
TEST(Spins, HaveTheEnergyOfThoseThatThereAre) {
  const Eigen::Matrix3d quadratic{{0.6, 0.1, -0.2}, {0.1, -0.3, 0.15}, {-0.2, 0.15, -1.2}};
  const std::array<double, 3> along{0.3, -0.2, 0.5};
  const Eigen::Matrix2d exchange{{0, 0.4}, {0.4, 0}};
  const spins pair(quadratic, along, exchange, 0, constant_noise<spins::group>::isotropic(0, 6));
  spins::state<double> two(6), state(9);
  for (int k = 0; k < 9; ++k) state[k] = 5;
  const vector nu{{-0.2, 0.5, 0.4}};
  spins::group::set_part(two, 0, mu);
  spins::group::set_part(two, 1, nu);
  state = two;
  const spin site(quadratic, along, 0, constant_noise<so3>());
  EXPECT_NEAR(pair.energy(state), site.energy(mu) + site.energy(nu) + 0.4 * dot(mu, nu), 1e-15);
}

}  // namespace
}  // namespace polhode
