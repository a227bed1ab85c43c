// SPDX-License-Identifier: Apache-2.0
// The flows that systems split into: exact ones against Boost.Odeint, others by the order of their error.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include <polhode/systems/maxwell_bloch.hpp>
#include <polhode/systems/sine_euler.hpp>
#include <polhode/systems/son_body.hpp>
#include <polhode/systems/spin.hpp>
#include <polhode/systems/spins.hpp>
#include <polhode/systems/varying_spin.hpp>
#include <polhode/systems/vortices.hpp>

#include "references/odeint.hpp"
#include "support/heavy_top.hpp"
#include "support/schemes.hpp"

namespace polhode::test {
namespace {

using vector = vec<double, 3>;
using pair = vec<double, 6>;

template <int N, class Drift>
vec<double, N> by_odeint(const Drift& drift, const vec<double, N>& mu, double t) {
  const auto end = solve_drift(
      [&](std::span<const double> x, std::span<double> out) {
        vec<double, N> m;
        std::ranges::copy(x, m.c.begin());
        std::ranges::copy(drift(m).c, out.begin());
      },
      mu.c, t);
  vec<double, N> out;
  std::ranges::copy(end, out.c.begin());
  return out;
}

const constant_noise<so3> silent;

spin spin_of(const Eigen::Matrix3d& quadratic, const std::array<double, 3>& field) {
  return {quadratic, field, 0.7, silent};
}

Eigen::Matrix3d tilted() {
  Eigen::Matrix3d q;
  q << 1, 0.3, -0.2, 0.3, -0.5, 0.1, -0.2, 0.1, 0.2;
  return q;
}

const vector start{{0.9, -0.4, 0.7}};

vector damped_drift(const spin& s, const vector& x) { return s.theta * cross(x, cross(x, s.omega(x))); }

TEST(Flows, OfASpinsDissipationAreExactWithoutAFieldAndInAFieldAlone) {
  for (const auto& s : {spin_of(tilted(), {0, 0, 0}), spin_of(Eigen::Matrix3d::Zero(), {0.3, -0.2, 0.5}),
                        spin_of(-2 * Eigen::Matrix3d::Identity(), {0, 0, -1.5})})
    for (const double t : {0.1, 1.0, 5.0}) {
      const auto truth = by_odeint([&](const vector& x) { return damped_drift(s, x); }, start, t);
      EXPECT_LE(distance(s.dissipation_flow(start, t), truth), 1e-12) << t;
    }
}

TEST(Flows, OfASpinsMotionAreExactInAFieldAlone) {
  const auto s = spin_of(Eigen::Matrix3d::Zero(), {0.3, -0.2, 0.5});
  const auto truth = by_odeint([&](const vector& x) { return cross(x, s.omega(x)); }, start, 2.0);
  EXPECT_LE(distance(s.free_flow(start, 2.0), truth), 1e-13);
  EXPECT_LE(distance(s.last_turn(s.first_turn(start, 2.0), 2.0), truth), 1e-13);
}

TEST(Flows, OfNoiseThatDependsOnTheStateAreExactVectorByVectorInAPalindrome) {
  const vector v[] = {{{0.3, 0.4, 0.5}}, {{-0.5, 0.2, 0.3}}, {{0.1, 0.6, -0.4}}};
  for (const auto form : {state_noise::damped, state_noise::quadratic}) {
    const varying_spin s{{tilted(), {0.3, -0.2, 0.5}, 0.7, spin::from_vectors(v)}, form};
    const wiener<double, 3> w{0.5, {{0.8, -1.1, 0.4}}};
    auto truth = start;
    for (const auto& [i, share] : {std::pair(0, 0.5), {1, 0.5}, {2, 1.0}, {1, 0.5}, {0, 0.5}}) {
      const auto sigma = [&](const vector& x) {
        return form == state_noise::damped ? v[i] + 0.7 * cross(x, v[i])
                                           : (dot(v[i], x) / std::sqrt(dot(v[i], v[i]))) * v[i];
      };
      truth = by_odeint([&](const vector& x) { return w.dw[i] * cross(x, sigma(x)); }, truth, share);
    }
    EXPECT_LE(distance(s.noise_flow(start, w), truth), 1e-13);
  }
}

/// log2 of the ratio of the errors of one flow of t and of t / 2.
template <class Flow, class Drift, int N>
double order_of(const Flow& flow, const Drift& drift, const vec<double, N>& mu, double t) {
  const auto error = [&](double time) { return distance(flow(mu, time), by_odeint(drift, mu, time)); };
  return std::log2(error(t) / error(t / 2));
}

TEST(Flows, OfASpinAreOfSecondOrderInAField) {
  const auto s = spin_of(tilted(), {0.3, -0.2, 0.5});
  EXPECT_NEAR(order_of([&](const vector& x, double t) { return s.dissipation_flow(x, t); },
                       [&](const vector& x) { return damped_drift(s, x); }, start, 0.02),
              3, 0.1);
  EXPECT_NEAR(order_of([&](const vector& x, double t) { return s.free_flow(x, t); },
                       [&](const vector& x) { return cross(x, s.omega(x)); }, start, 0.02),
              3, 0.1);
  const auto palindrome = [&](const vector& x, double t) {
    return s.first_turn(s.last_turn(s.first_turn(x, t / 2), t), t / 2);
  };
  EXPECT_NEAR(order_of(
                  palindrome, [&](const vector& x) { return cross(x, s.omega(x)); }, start, 0.02),
              3, 0.1);
}

const pair both{{0.6, 0.48, 0.64, -0.3, 0.8, 0.5}};

/// Two spherical bodies: of h the coupling alone is left.
so4_body coupling_alone() { return {{1, 1, 1, 1, 1, 1}, 0.9, 0.7, constant_noise<so4>()}; }

TEST(Flows, OfTheCouplingAloneAreExact) {
  const auto s = coupling_alone();
  for (const double t : {0.1, 1.0, 4.0}) {
    const auto damped =
        by_odeint([&](const pair& x) { return s.theta * so4::coad(so4::coad(s.omega(x), x), x); }, both, t);
    EXPECT_LE(distance(s.dissipation_flow(both, t), damped), 1e-12) << t;
    const auto free = by_odeint([&](const pair& x) { return so4::coad(s.omega(x), x); }, both, t);
    EXPECT_LE(distance(s.free_flow(both, t), free), 1e-12) << t;
  }
}

TEST(Flows, OfCoupledBodiesAreOfSecondOrder) {
  const auto s = coupled_bodies();
  EXPECT_NEAR(order_of([&](const pair& x, double t) { return s.dissipation_flow(x, t); },
                       [&](const pair& x) { return s.theta * so4::coad(so4::coad(s.omega(x), x), x); }, both, 0.02),
              3, 0.1);
  EXPECT_NEAR(order_of([&](const pair& x, double t) { return s.free_flow(x, t); },
                       [&](const pair& x) { return so4::coad(s.omega(x), x); }, both, 0.02),
              3, 0.1);
}

pair top_drift(const heavy_top& s, const pair& x) { return se3::coad(s.omega(x), x); }

TEST(Flows, OfAHeavyTopsGravityAloneAreExact) {
  const auto s = asymmetric_top();
  const auto pull = [&](const pair& x) { return se3::coad(se3::joined(vector{}, s.pull), x); };
  for (const double t : {0.1, 1.0, 4.0})
    EXPECT_LE(distance(s.first_turn(top_state, t), by_odeint(pull, top_state, t)), 1e-12) << t;
}

TEST(Flows, OfAHeavyTopAreOfSecondOrder) {
  const auto s = asymmetric_top();
  const auto damping = [&](const pair& x) { return s.theta * se3::coad(se3::coad(s.omega(x), x), x); };
  EXPECT_NEAR(order_of([&](const pair& x, double t) { return s.dissipation_flow(x, t); }, damping, top_state, 0.02), 3,
              0.1);
  const auto drift = [&](const pair& x) { return top_drift(s, x); };
  EXPECT_NEAR(order_of([&](const pair& x, double t) { return s.free_flow(x, t); }, drift, top_state, 0.02), 3, 0.1);
}

/// Of the true path: a top whose axis is one of symmetry keeps Pi_3 (Lagrange); with I_1 = I_2 = 2 I_3 and the centre
/// of mass on axis 1, |(Pi_1 + i Pi_2)^2 / 4 I_3^2 - (weight / I_3)(Gamma_1 + i Gamma_2)|^2 is kept (Kovalevskaya
/// 1889).
TEST(Flows, KeepTheIntegralsOfTheClassicalTops) {
  const heavy_top lagrange({1.4, 1.4, 0.8}, 1.3, {0, 0, 1}, 0, {}), kovalevskaya({2, 2, 1}, 1.3, {1, 0, 0}, 0, {});
  const auto kovalevskayas = [](const pair& x) {
    const double p = x[0] / 2, q = x[1] / 2, real = p * p - q * q - 1.3 * x[3], imaginary = 2 * p * q - 1.3 * x[4];
    return real * real + imaginary * imaginary;
  };
  for (const double t : {0.5, 3.0}) {
    const auto l = by_odeint([&](const pair& x) { return top_drift(lagrange, x); }, top_state, t);
    EXPECT_NEAR(l[2], top_state[2], 1e-12) << t;
    EXPECT_NEAR(lagrange.energy(l), lagrange.energy(top_state), 1e-12) << t;
    const auto k = by_odeint([&](const pair& x) { return top_drift(kovalevskaya, x); }, top_state, t);
    EXPECT_NEAR(kovalevskayas(k), kovalevskayas(top_state), 1e-11) << t;
    EXPECT_GT(distance(k, top_state), 0.1) << t;
  }
}

TEST(Flows, OfMaxwellAndBlochsPartsAreExact) {
  const maxwell_bloch s(0.7, {});
  for (const double t : {0.1, 1.0, 4.0}) {
    const auto shifted = by_odeint([](const vector& x) { return vector{{x[1], 0, 0}}; }, start, t);
    EXPECT_LE(distance(s.first_turn(start, t), shifted), 1e-12) << t;
    const auto turned = by_odeint([](const vector& x) { return vector{{0, x[0] * x[2], -x[0] * x[1]}}; }, start, t);
    EXPECT_LE(distance(s.last_turn(start, t), turned), 1e-12) << t;
  }
}

TEST(Flows, OfMaxwellAndBlochAreOfSecondOrder) {
  const maxwell_bloch s(0.7, {});
  const auto equation = [](const vector& x) { return vector{{x[1], x[0] * x[2], -x[0] * x[1]}}; };
  EXPECT_LE(distance(se2::coad(s.omega(start), start), equation(start)), 1e-16);
  EXPECT_NEAR(order_of([&](const vector& x, double t) { return s.free_flow(x, t); }, equation, start, 0.02), 3, 0.1);
  EXPECT_NEAR(order_of([&](const vector& x, double t) { return s.dissipation_flow(x, t); },
                       [&](const vector& x) { return s.theta * se2::coad(se2::coad(s.omega(x), x), x); }, start, 0.02),
              3, 0.1);
}

/// Of a system whose size is known at run time alone: both flows against Odeint.
template <class System>
void expect_flows_of_second_order(const System& s, int components) {
  using algebra = typename System::algebra;
  using state = vec<double, algebra::dimension>;
  const auto by_solver = [](const auto& drift, const state& mu, double t) {
    const std::vector<double> first(mu.begin(), mu.end());
    const auto end = solve_drift(
        [&](std::span<const double> x, std::span<double> out) {
          state m(static_cast<int>(x.size()));
          std::ranges::copy(x, m.begin());
          std::ranges::copy(drift(m), out.begin());
        },
        first, t);
    state out(mu.size);
    std::ranges::copy(end, out.begin());
    return out;
  };
  state mu(components);
  for (int k = 0; k < components; ++k) mu[k] = normals<24>({5, noise_kind::initial_state, 0, 0})[k];
  const auto order = [&](const auto& flow, const auto& drift) {
    const auto error = [&](double t) {
      const auto apart = flow(mu, t) - by_solver(drift, mu, t);
      return std::sqrt(dot(apart, apart));
    };
    return std::log2(error(0.02) / error(0.01));
  };
  EXPECT_NEAR(order([&](const state& x, double t) { return s.dissipation_flow(x, t); },
                    [&](const state& x) { return s.theta * algebra::coad(algebra::coad(s.omega(x), x), x); }),
              3, 0.1);
  EXPECT_NEAR(order([&](const state& x, double t) { return s.free_flow(x, t); },
                    [&](const state& x) { return algebra::coad(s.omega(x), x); }),
              3, 0.1);
}

TEST(Flows, OfCoupledSpinsAreOfSecondOrder) {
  const Eigen::Matrix3d ring = 0.6 * (Eigen::Matrix3d::Ones() - Eigen::Matrix3d::Identity());
  expect_flows_of_second_order(spins(tilted(), {0.3, -0.2, 0.5}, ring, 0.7, spins::isotropic(0, 9)), 9);
}

TEST(Flows, OfBodiesInMoreDimensionsAreOfSecondOrder) {
  const std::vector<double> lambda{1, 1.4, 0.7, 2, 1.2, 0.9};
  for (const int n : {4, 5, 6}) {
    const int components = n * (n - 1) / 2;
    expect_flows_of_second_order(
        son_body({lambda.begin(), lambda.begin() + n}, 0.3, son_body::isotropic(0, components)), components);
  }
}

TEST(Flows, OfVorticesAreOfSecondOrder) {
  expect_flows_of_second_order(vortices({1.2, -0.8, 1.5}, 0.3, spins::isotropic(0, 9)), 9);
}

TEST(Flows, OfTheFluidOnTheTorusAreOfSecondOrder) {
  for (const int n : {3, 5})
    expect_flows_of_second_order(sine_euler(n, 0.3, sine_euler::isotropic(0, n * n - 1)), n * n - 1);
}

}  // namespace
}  // namespace polhode::test
