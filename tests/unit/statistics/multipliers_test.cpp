// SPDX-License-Identifier: Apache-2.0
// What an extrapolation leaves open is what it leaves of a geometric series, and no more than was corrected; a strength
// is found beside errors that fall with dt, and its interval covers.
#include "statistics/multipliers.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <polhode/noise/normal.hpp>
#include <vector>

#include "statistics/distributions.hpp"
#include "support/dense.hpp"

namespace polhode {
namespace {

const std::vector<double> level_dt{0.08, 0.04, 0.02, 0.01};

struct extrapolation {
  double limit, first, second;
};
template <class function>
extrapolation at_zero(const function& f) {
  const auto line = constant_of_polynomial(level_dt, 1), quadratic = constant_of_polynomial(level_dt, 2);
  double by_line = 0, limit = 0;
  for (std::size_t l = 0; l < level_dt.size(); ++l) {
    by_line += line[static_cast<Eigen::Index>(l)] * f(level_dt[l]);
    limit += quadratic[static_cast<Eigen::Index>(l)] * f(level_dt[l]);
  }
  return {limit, f(level_dt.back()) - limit, by_line - limit};
}

TEST(LeftOpen, IsWhatIsLeftOfAGeometricSeries) {
  for (const double rate : {0.01, 0.1, 1.0, -1.0}) {
    const auto found = at_zero([=](double x) { return 1 / (1 - rate * x); });
    const double open = left_open(level_dt, found.first, found.second, 0), left = std::fabs(found.limit - 1);
    EXPECT_NEAR(open / left, 1, 3 * std::fabs(rate) * level_dt.front()) << rate;
    EXPECT_LT(open, std::fabs(found.second)) << rate;
  }
}

TEST(LeftOpen, IsAllOfTheCorrectionWhereItIsNoSmallerThanTheOneBefore) {
  const auto square = at_zero([](double x) { return x * x; });
  EXPECT_NEAR(square.limit, 0, 1e-15);
  EXPECT_EQ(left_open(level_dt, 0, 0.25, 0), 0.25);
  EXPECT_EQ(left_open(level_dt, 1e-9, -0.25, 0), 0.25);
}

TEST(LeftOpen, IsNothingThatIsWithinItsError) {
  EXPECT_EQ(left_open(level_dt, 0.5, 0.019, 0.01), 0);
  EXPECT_GT(left_open(level_dt, 0.5, 0.021, 0.01), 0);
  EXPECT_EQ(left_open(level_dt, 0, 0, 0), 0);
}

/// One direction S = 1 + g / 2, and the error (eps + (dt + 5 dt^2) / 2) S + dt h / 2, g and h normal.
multiplier strength_beside(double eps, std::uint64_t seed) {
  constexpr int paths = 320;
  response_data d(paths, 1, static_cast<int>(level_dt.size()));
  for (int p = 0; p < paths; ++p) {
    const auto g = normals<3>({seed, noise_kind::increment, static_cast<std::uint64_t>(p), 0});
    const double size = 1 + g[0] / 2;
    d.gram_of(p)[0] = size * size;
    for (std::size_t l = 0; l < level_dt.size(); ++l) {
      const double own = (level_dt[l] + 5 * level_dt[l] * level_dt[l]) / 2;
      d.response_of(p, static_cast<int>(l))[0] = size * ((eps + own) * size + g[1] * 0.05 + level_dt[l] * g[2] / 2);
    }
  }
  return effective_multipliers(level_dt, d, paths, 32).front();
}

TEST(EffectiveMultipliers, CoverWhatIsTrueAndNoMoreOftenThanTheySay) {
  constexpr int seeds = 1000;
  for (const double eps : {0.0, 0.3}) {
    int covered = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      const auto m = strength_beside(eps, seed);
      ASSERT_TRUE(m.known);
      EXPECT_LT(std::fabs(m.error.value - eps), m.sure) << seed;
      covered += m.error.low <= eps && eps <= m.error.high;
    }
    EXPECT_GE(covered, 0.95 * seeds - 4 * std::sqrt(0.05 * 0.95 * seeds)) << eps;
    EXPECT_LE(covered, 0.97 * seeds + 4 * std::sqrt(0.03 * 0.97 * seeds)) << eps;
  }
}

// Directions S, 2 S and another; the error is 0.1 of the first and 0.2 of the last.
TEST(EffectiveMultipliers, AreTheSameInAnyUnitAndNotKnownOfWhatFollowsFromOthers) {
  constexpr int paths = 320;
  for (const double unit : {0x1p-20, 1.0, 0x1p20}) {
    response_data d(paths, 3, static_cast<int>(level_dt.size()));
    for (int p = 0; p < paths; ++p) {
      const auto g = normals<2>({3, noise_kind::increment, static_cast<std::uint64_t>(p), 0});
      const double s[] = {unit * (1 + g[0] / 2), unit * (2 + g[0]), unit * g[1]};
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 3; ++k) d.gram_of(p)[3 * j + k] = s[j] * s[k];
      for (std::size_t l = 0; l < level_dt.size(); ++l)
        for (int k = 0; k < 3; ++k) d.response_of(p, static_cast<int>(l))[k] = s[k] * (0.1 * s[0] + 0.2 * s[2]);
    }
    const auto found = effective_multipliers(level_dt, d, paths, 32);
    ASSERT_EQ(found.size(), 3u);
    EXPECT_TRUE(found[0].known) << unit;
    EXPECT_FALSE(found[1].known) << unit;
    EXPECT_TRUE(found[2].known) << unit;
    EXPECT_NEAR(found[0].error.value, 0.1, 1e-12) << unit;
    EXPECT_NEAR(found[2].error.value, 0.2, 1e-12) << unit;
    EXPECT_NEAR(found[2].size, unit, 0.2 * unit);
  }
}

// Weights 1 / dt on the levels: the normal equations, written out.
TEST(ConstantOfPolynomial, IsTheWeightedLeastSquares) {
  for (const int degree : {1, 2}) {
    Eigen::MatrixXd design(4, degree + 1);
    Eigen::VectorXd weight(4);
    for (Eigen::Index l = 0; l < 4; ++l) {
      const double x = level_dt[static_cast<std::size_t>(l)] / 0.01;
      weight[l] = 1 / (x * x);
      for (int k = 0; k <= degree; ++k) design(l, k) = std::pow(x, k);
    }
    const Eigen::MatrixXd left = design.transpose() * weight.asDiagonal();
    const Eigen::VectorXd expected = test::solution_of(left * design, left).row(0).transpose();
    EXPECT_LT((constant_of_polynomial(level_dt, degree) - expected).norm(), 1e-12) << degree;
  }
}

// Corrections that do not fall leave all that is seen of the last one, beyond its error.
TEST(LeftOpen, IsAllThatIsSeenWhereTheNextWouldBeLarger) {
  EXPECT_DOUBLE_EQ(left_open(level_dt, 0, 0.25, 0.05), 0.25 - 1.96 * 0.05);
  const Eigen::Vector4d x(8, 4, 2, 1);
  const double line = constant_of_polynomial(level_dt, 1).dot(x.cwiseProduct(x)),
               quadratic = constant_of_polynomial(level_dt, 2).dot(x.cwiseProduct(x).cwiseProduct(x));
  const auto open = [&](double further) {
    return left_open(level_dt, 0.25 * quadratic / (line * line) / further, 0.25, 0.05);
  };
  EXPECT_NEAR(open(0.5), 0.5 * (0.25 - 0.098), 1e-13);
  EXPECT_NEAR(open(1.5), 0.25 - 0.098, 1e-13);
}

// Of one direction, each sum written out; with a limit that bends by nothing or by more than its error.
void expect_sums_over_paths(double bend) {
  constexpr int paths = 50, cells = 4;
  response_data d(paths, 1, 4);
  double gram = 0;
  std::vector<double> g(paths), limit(paths), line(paths), finest(paths);
  const auto quadratic = constant_of_polynomial(level_dt, 2), linear = constant_of_polynomial(level_dt, 1);
  for (int p = 0; p < paths; ++p) {
    const auto z = normals<6>({9, noise_kind::increment, static_cast<std::uint64_t>(p), 0});
    const auto at = static_cast<std::size_t>(p);
    g[at] = d.gram_of(p)[0] = 1 + z[0] * z[0];
    gram += g[at] / paths;
    for (int l = 0; l < 4; ++l) {
      const double r = d.response_of(p, l)[0] =
          (0.3 + bend * std::pow(level_dt[static_cast<std::size_t>(l)], 2)) * g[at] + 0.02 * z[l + 1];
      limit[at] += quadratic[l] * r;
      line[at] += linear[l] * r;
      finest[at] = r;
    }
  }
  const auto mean = [&](const std::vector<double>& x) {
    double sum = 0;
    for (const double value : x) sum += value / paths;
    return sum / gram;
  };
  const double eps = mean(limit), change = mean(line) - eps, step = mean(finest) - eps;
  double variance = 0, of_change = 0;
  for (std::size_t p = 0; p < paths; ++p) {
    variance += std::pow((limit[p] - g[p] * eps) / gram, 2);
    of_change += std::pow((line[p] - limit[p]) / gram - change, 2);
  }
  const double error = std::sqrt(variance) / paths, cell = std::fabs(step) / cells,
               open = left_open(level_dt, step, change, std::sqrt(of_change) / paths),
               half = half_width_with_bias(error, open + cell);
  EXPECT_EQ(open > 0, bend > 0);
  const auto m = effective_multipliers(level_dt, d, paths, cells).front();
  ASSERT_TRUE(m.known);
  EXPECT_NEAR(m.error.value, eps, 1e-13);
  EXPECT_NEAR(m.error.low, eps - half, 1e-12);
  EXPECT_NEAR(m.error.high, eps + half, 1e-12);
  EXPECT_NEAR(m.sure, family_z * error + std::fabs(change) + cell, 1e-12);
  EXPECT_NEAR(m.size, std::sqrt(gram), 1e-13);
}

TEST(EffectiveMultipliers, AreTheSumsOverPaths) {
  for (const double bend : {0.0, 40.0}) expect_sums_over_paths(bend);
}

// The unit of time is anybody's: powers of a small one lie far apart.
TEST(ConstantOfPolynomial, IsTheSameInAnyUnit) {
  const auto expected = constant_of_polynomial(level_dt, 2);
  for (const double unit : {0x1p-30, 0x1p30}) {
    auto scaled = level_dt;
    for (double& x : scaled) x *= unit;
    EXPECT_LT((constant_of_polynomial(scaled, 2) - expected).norm(), 1e-13) << unit;
  }
}

// S_1 = (8, 0) and S_2 = (7, 1): a fiftieth of the square of the second is its own.
TEST(EffectiveMultipliers, ADirectionIsKnownByMoreThanAFiftiethOfIt) {
  const auto known = [](double own) {
    response_data d(1, 2, 4);
    const double gram[] = {64, 56, 56, 49 + own};
    std::copy(gram, gram + 4, d.gram_of(0));
    return static_cast<bool>(effective_multipliers(level_dt, d, 1, 4)[1].known);
  };
  EXPECT_FALSE(known(1));
  EXPECT_TRUE(known(1.001));
}

}  // namespace
}  // namespace polhode
