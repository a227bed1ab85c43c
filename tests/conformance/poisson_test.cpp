// SPDX-License-Identifier: Apache-2.0
// Whether a step without noise and dissipation is a Poisson map, on so(3), so(4) and se(3): schemes that claim it are
// to rounding, and the others are not.
#include <gtest/gtest.h>

#include <vector>

#include <Eigen/Core>

#include <polhode/dual.hpp>

#include "support/heavy_top.hpp"
#include "support/schemes.hpp"
#include "support/spin.hpp"

namespace polhode::test {
namespace {

constexpr double rounding = 1e-14, no_rounding = 1e-9;

/// The bodies' free motion by a map of second order that keeps the Casimirs and is no flow of any energy.
struct approximate_bodies : so4_body {
  approximate_bodies() : so4_body(coupled_bodies(0)) {}
  template <class S>
  vec<S, 6> last_turn(const vec<S, 6>& mu, double t) const {
    const auto first = S(t) * scaled(inverse_inertia, mu);
    const auto second = S(t) * scaled(inverse_inertia, so4::exp_action(first, mu));
    return so4::exp_action(S(0.5) * (first + second), mu);
  }
  template <class S>
  vec<S, 6> free_flow(const vec<S, 6>& mu, double t) const {
    return last_turn(first_turn(mu, t), t);
  }
  approximate_bodies with_noise(const constant_noise<so4>& other) const {
    approximate_bodies copy = *this;
    static_cast<constant_noise<so4>&>(copy) = other;
    return copy;
  }
};

template <class System, int N = System::dimension>
Eigen::Matrix<double, N, N> bracket_at(const vec<double, N>& mu) {
  Eigen::Matrix<double, N, N> out;
  for (int k = 0; k < N; ++k) {
    vec<double, N> unit{};
    unit[k] = 1;
    const auto column = System::algebra::coad(unit, mu);
    for (int j = 0; j < N; ++j) out(j, k) = column[j];
  }
  return out;
}

template <class Scheme, class System, int N = System::dimension>
double defect(const System& system, const vec<double, N>& mu, double dt) {
  using number = dual<double, N>;
  wiener_levy<number, System::channels> w;
  w.dt = dt;
  const auto next = Scheme::step(prepared<Scheme>(system, dt), seeded(mu), w);
  Eigen::Matrix<double, N, N> jacobian;
  vec<double, N> end;
  for (int j = 0; j < N; ++j) {
    end[j] = next[j].value;
    for (int k = 0; k < N; ++k) jacobian(j, k) = next[j].slope[k];
  }
  const auto after = bracket_at<System>(end);
  return (jacobian * bracket_at<System>(mu) * jacobian.transpose() - after).norm() / after.norm();
}

template <class Scheme>
struct PoissonMap : testing::Test {};
TYPED_TEST_SUITE(PoissonMap, every_scheme);

TYPED_TEST(PoissonMap, IsWhatItClaims) {
  const vec<double, 6> mu{{0.6, 0.48, 0.64, -0.3, 0.8, 0.5}};
  std::vector<double> found{defect<TypeParam>(paper_body(0, 0.5), paper_momentum, 0.1),
                            defect<TypeParam>(coupled_bodies(0), mu, 0.1),
                            defect<TypeParam>(tilted_spin(0), paper_momentum, 0.1)};
  if constexpr (scheme_on<TypeParam, heavy_top>) found.push_back(defect<TypeParam>(asymmetric_top(0), top_state, 0.1));
  for (const double d : found) {
    if (TypeParam::info.poisson)
      EXPECT_LE(d, rounding);
    else
      EXPECT_GE(d, no_rounding);
  }
}

// Flows that are not exact are no Poisson maps: that the test refutes.
TYPED_TEST(PoissonMap, IsNoneByFlowsOfSecondOrder) {
  const vec<double, 6> mu{{0.6, 0.48, 0.64, -0.3, 0.8, 0.5}};
  const bool needs_no_flows = TypeParam::info.implicit && TypeParam::info.poisson;
  if (!needs_no_flows) {
    EXPECT_GE(defect<TypeParam>(approximate_bodies(), mu, 0.1), no_rounding);
  }
}

// Dissipation contracts areas on the orbit.
TYPED_TEST(PoissonMap, IsNoneWithDissipation) {
  EXPECT_GE(defect<TypeParam>(paper_body(0.5, 0.5), paper_momentum, 0.1), no_rounding);
}

}  // namespace
}  // namespace polhode::test
