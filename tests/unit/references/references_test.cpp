// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "references/free_rotation.hpp"
#include "references/odeint.hpp"
#include "references/wong_zakai_equation.hpp"
#include "sphere/closed_forms/gibbs.hpp"
#include "support/schemes.hpp"

namespace polhode::test {
namespace {

drift_function free_drift(std::array<double, 3> i) {
  return [i](std::span<const double> p, std::span<double> out) {
    const double a = p[0] / i[0], b = p[1] / i[1], c = p[2] / i[2];
    out[0] = p[1] * c - p[2] * b;
    out[1] = p[2] * a - p[0] * c;
    out[2] = p[0] * b - p[1] * a;
  };
}

void agree(const std::array<double, 3>& inertia, const std::array<double, 3>& pi, double t, double tolerance = 1e-12) {
  const auto closed = free_rotation(inertia, pi, t);
  const auto solved = solve_drift(free_drift(inertia), pi, t);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(closed[k], solved[k], tolerance) << inertia[0] << ' ' << inertia[1] << ' ' << inertia[2] << " t " << t;
}

TEST(FreeRotation, AgreesWithOdeintForEveryOrderOfAxesAndSigns) {
  for (const auto& inertia : std::vector<std::array<double, 3>>{{1, 2, 3},
                                                                {1, 3, 2},
                                                                {2, 1, 3},
                                                                {2, 3, 1},
                                                                {3, 1, 2},
                                                                {3, 2, 1},
                                                                {1, 1, 2.5},
                                                                {2.5, 1, 2.5},
                                                                {1, 10, 100},
                                                                {2, 2, 2}})
    for (int signs = 0; signs < 8; ++signs)
      for (const double tilt : {0.05, 0.4, 1.0})
        agree(inertia,
              {(signs & 1 ? -0.6 : 0.6) * tilt, signs & 2 ? -0.48 : 0.48, (signs & 4 ? -0.64 : 0.64) / (1 + tilt)},
              7.3);
}

// A first trial step as long as a thousandth of such a time would overflow.
TEST(Odeint, IsFiniteOverALongTime) {
  const auto end = solve_drift(free_drift({1, 2, 3}), std::array{0.6, 0.48, 0.64}, 1e5);
  EXPECT_NEAR(std::hypot(end[0], end[1], end[2]), std::hypot(0.6, 0.48, 0.64), 1e-9);
}

TEST(FreeRotation, HoldsOnTheSeparatrixAndOnTheAxes) {
  for (const double sign : {1.0, -1.0}) agree({1, 2, 3}, {sign * 0.6 / std::sqrt(3.0), 0.5, 0.6}, 3.0);
  for (int axis = 0; axis < 3; ++axis) {
    std::array<double, 3> pi{};
    pi[static_cast<std::size_t>(axis)] = -0.7;
    EXPECT_EQ(free_rotation({1, 2, 3}, pi, 5.0), pi);
  }
}

// The reference of the strong experiment converges at order four to odeint; its sign conventions stand or fall with
// this.
TEST(WongZakaiEquation, IsOfOrderFour) {
  const auto system = paper_body();
  const vec<double, 3> dw{{0.7, -1.1, 0.4}};
  const auto truth = solve_drift(
      [&](std::span<const double> x, std::span<double> out) {
        const vec<double, 3> mu{{x[0], x[1], x[2]}};
        const auto rate = so3::coad(system.generator(mu) + system.noise(dw), mu);
        std::ranges::copy(rate.c, out.begin());
      },
      paper_momentum.c, 1.0);
  const auto error = [&](int n) {
    auto mu = paper_momentum;
    for (int i = 0; i < n; ++i) mu = wong_zakai_equation::step(system, mu, wiener<double, 3>{1.0 / n, (1.0 / n) * dw});
    return distance(mu, vec<double, 3>{{truth[0], truth[1], truth[2]}});
  };
  EXPECT_NEAR(std::log2(error(16) / error(32)), 4.0, 0.15);
  EXPECT_LT(error(512), 1e-13);
}

TEST(Gibbs, KnownAnswers) {  // docs/model.md, section 3
  const gibbs_law law({1, 2, 3}, 1, 4);
  EXPECT_NEAR(law.mean_energy(), 0.27662786228, 6e-12);
  EXPECT_NEAR(law.energy_variance(), 0.00637133262, 6e-12);
  EXPECT_NEAR(law.mean_square(0), 0.24176699009, 6e-12);
  EXPECT_NEAR(law.mean_square(2), 0.40576662289, 6e-12);
}

// Near the axis of least energy the law is Gaussian: half of 1 / beta for each of two squares.
TEST(Gibbs, UnderFaintNoiseIsGaussian) {
  for (const double c : {1.0, 1e3, 1e5}) {
    const double beta = 2e6;
    const gibbs_law law({1, 2, 3}, c, beta);
    EXPECT_LT(law.relative_uncertainty(), 1e-13);
    const double second_order = 5 / (beta * c * c);
    EXPECT_NEAR(law.mean_square(0) * beta, 1.5, 1.5 * second_order + 1e-12);
    EXPECT_NEAR(law.mean_square(1) * beta, 6, 30 * second_order + 1e-12);
    EXPECT_NEAR(law.excess_energy() * beta, 1, 5 * second_order + 1e-12);
    EXPECT_NEAR(law.energy_variance() * beta * beta, 1, 20 * second_order + 1e-11);
    if (c < 1e4) {
      EXPECT_NEAR(law.energy_cdf(law.least_energy() + 1 / beta), 1 - std::exp(-1.0), c == 1 ? 3e-6 : 1e-4);
    }
  }
}

// Two axes alike up to rounding: the closed form of the body of revolution.
TEST(Gibbs, NearlySymmetricBodiesAreAsBodiesOfRevolution) {
  for (const double beta : {0.0, 3.0, 300.0, 3e6})
    for (const double ratio : {1e-3, 0.3, 4.0, 1e3}) {
      const gibbs_law round({1, 1, ratio}, 1, beta), nearly({1, 1 + 1e-13, ratio}, 1, beta);
      for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(nearly.mean_square(k), round.mean_square(k), 1e-12 * (1 + beta) * round.mean_square(k));
      EXPECT_NEAR(round.mean_square(0) + round.mean_square(1) + round.mean_square(2), 1, 1e-13);
    }
}

TEST(Gibbs, WithoutDissipationIsUniform) {
  for (const auto& i :
       std::vector<std::array<double, 3>>{{1, 2, 3}, {3, 1, 2}, {1, 1, 2.5}, {2.5, 1, 1}, {1, 10, 100}}) {
    const gibbs_law law(i, 2, 0);
    EXPECT_NEAR(law.mean_energy(), 4.0 / 6 * (1 / i[0] + 1 / i[1] + 1 / i[2]), 1e-11);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(law.mean_square(k), 4.0 / 3, 1e-10);
  }
}

// For a symmetric body h is a quadratic in Pi_3 alone, and the law of Pi_3 is elementary.
TEST(Gibbs, SymmetricBodyInClosedForm) {
  const double beta = 3, c = 1.2, a = 0.5 * (1 / 2.5 - 1.0);  // h = c^2/2 + a z^2
  const gibbs_law law({1, 1, 2.5}, c, beta);
  const double k = std::sqrt(-beta * a);
  const auto dawson_like = [&](double z) {  // integral of exp(k^2 u^2) from 0 to z, by Simpson
    constexpr int n = 2000;
    double sum = 0;
    for (int i = 0; i < n; ++i) {
      const double u = z * i / n, v = z * (i + 1) / n, m = 0.5 * (u + v);
      sum += z / n / 6 * (std::exp(k * k * u * u) + 4 * std::exp(k * k * m * m) + std::exp(k * k * v * v));
    }
    return sum;
  };
  for (const double z : {0.1, 0.5, 0.9, 1.1}) {
    const double h = 0.5 * c * c + a * z * z;  // decreasing in z: P(h' <= h) = P(|z'| >= z)
    EXPECT_NEAR(law.energy_cdf(h), 1 - dawson_like(z) / dawson_like(c), 2e-6) << z;
  }
}

TEST(Gibbs, DistributionFunctionIsOne) {
  const gibbs_law law({1, 2, 3}, 1, 4);
  EXPECT_EQ(law.energy_cdf(law.least_energy()), 0);
  EXPECT_EQ(law.energy_cdf(law.greatest_energy()), 1);
  double last = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double now = law.energy_cdf(std::lerp(law.least_energy(), law.greatest_energy(), i / 1000.0));
    EXPECT_GE(now, last);
    last = now;
  }
}

}  // namespace
}  // namespace polhode::test
