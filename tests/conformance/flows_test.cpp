// The flows that systems split into: exact ones against Boost.Odeint, others by the order of their error.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include <polhode/systems/spin.hpp>

#include "references/odeint.hpp"
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

}  // namespace
}  // namespace polhode::test
