// SPDX-License-Identifier: Apache-2.0
// How strongly areas are felt is found beside a scheme's own larger error, and is not made up where there are none.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <polhode/noise/normal.hpp>
#include <vector>

#include "statistics/distributions.hpp"
#include "statistics/noise/area_strength.hpp"

namespace polhode {
namespace {

constexpr int levels = 8, cells = 32;

std::vector<double> steps() {
  std::vector<double> dt;
  for (int l = 0; l < levels; ++l) dt.push_back(0.25 * std::exp2(-l));
  return dt;
}

/// What the areas do is areas sqrt(dt) g + drift dt h, the error eps times the former and own dt (h + k) / 2: normal
/// vectors g, h, k of three components, h and k once a path, as drift remembers its path.
struct synthetic {
  double areas, drift, own, eps;
};
area_response response_of(const synthetic& s, int paths, std::uint64_t seed) {
  const auto room = std::vector<double>(static_cast<std::size_t>(paths * levels));
  area_response out{{paths, levels, room}, {paths, levels, room}};
  const auto dt = steps();
  for (int p = 0; p < paths; ++p)
    for (int l = 0; l < levels; ++l) {
      const auto path = static_cast<std::uint64_t>(p), level = static_cast<std::uint64_t>(l);
      const auto g = normals<3>({seed, noise_kind::increment, path, level});
      const auto h = normals<3>({seed, noise_kind::area, path, 0}), k = normals<3>({seed, noise_kind::area, path, 1});
      const double h_step = dt[static_cast<std::size_t>(l)];
      for (int i = 0; i < 3; ++i) {
        const double by_areas = s.areas * std::sqrt(h_step) * g[i], by_drift = s.drift * h_step * h[i];
        const double error = s.eps * by_areas + s.own * h_step * (h[i] + k[i]) / 2;
        out.product.at(p, l) += (by_areas + by_drift) * error;
        out.square.at(p, l) += std::pow(by_areas + by_drift, 2);
      }
    }
  return out;
}

multiplier strength_of_areas(const synthetic& s, int paths = 320, std::uint64_t seed = 1) {
  return area_strength(steps(), response_of(s, paths, seed), paths, cells);
}

TEST(AreaStrength, IsOneOfHealthySchemes) {
  int covered = 0;
  constexpr int seeds = 200;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const auto m = strength_of_areas({1, 1, 2, 0}, 320, seed);
    ASSERT_TRUE(m.known);
    EXPECT_LT(std::fabs(m.error.value), m.sure) << seed;
    covered += m.error.low <= 0 && 0 <= m.error.high;
  }
  EXPECT_GE(covered, 0.95 * seeds - 4 * std::sqrt(0.05 * 0.95 * seeds));
}

TEST(AreaStrength, FivePerCentAreSeenBesideALargerErrorOfTheScheme) {
  for (const double eps : {-1.0, -0.05, 0.05}) {
    const auto m = strength_of_areas({1, 1, 0.2, eps});
    ASSERT_TRUE(m.known);
    EXPECT_GT(std::fabs(m.error.value), m.sure) << eps;
    EXPECT_NEAR(m.error.value, eps, m.sure);
  }
}

TEST(AreaStrength, IsNotKnownWhereTheNoiseCommutes) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    EXPECT_FALSE(strength_of_areas({0, 1, 1, 0}, 320, seed).known) << seed;
    EXPECT_FALSE(strength_of_areas({0, 0, 1, 0}, 320, seed).known) << seed;
  }
}

// Of six levels, over dt, each sum written out; of fewer than four nothing.
TEST(AreaStrength, IsTheSumsOverPaths) {
  constexpr int paths = 60;
  const auto r = response_of({1, 0.5, 0.5, 0.2}, paths, 3);
  const auto all = steps();
  const std::vector<double> dt(all.end() - 6, all.end());
  const auto quadratic = constant_of_polynomial(dt, 2), linear = constant_of_polynomial(dt, 1);
  const auto sum = [&](const squared_errors& e, const Eigen::VectorXd& weights) {
    Eigen::ArrayXd out = Eigen::ArrayXd::Zero(paths);
    for (int p = 0; p < paths; ++p)
      for (int l = 0; l < 6; ++l) out[p] += weights[l] * e.values[std::size_t(p * levels + l + 2)] / dt[std::size_t(l)];
    return out;
  };
  const Eigen::ArrayXd square = sum(r.square, quadratic), product = sum(r.product, quadratic),
                       less_square = sum(r.square, linear), less_product = sum(r.product, linear);
  const double area = square.mean(), eps = product.mean() / area;
  const auto error_of = [&](const Eigen::ArrayXd& x) { return std::sqrt((x - x.mean()).square().sum()) / paths; };
  const Eigen::ArrayXd of_change = (less_product - product - eps * (less_square - square)) / area;
  const double error = error_of((product - eps * square) / area), change = of_change.mean();
  const Eigen::VectorXd last = Eigen::VectorXd::Unit(6, 5);
  const double step = sum(r.product, last).mean() / sum(r.square, last).mean() - eps, cell = std::fabs(eps) / cells,
               half = half_width_with_bias(error, left_open(dt, step, change, error_of(of_change)) + cell);
  const auto m = area_strength(all, r, paths, cells);
  ASSERT_TRUE(m.known);
  EXPECT_NEAR(m.error.value, eps, 1e-13);
  EXPECT_NEAR(m.error.low, eps - half, 1e-12);
  EXPECT_NEAR(m.error.high, eps + half, 1e-12);
  EXPECT_NEAR(m.sure, family_z * error + std::fabs(change) + cell, 1e-12);
  EXPECT_NEAR(m.size, std::sqrt(area * dt.back()), 1e-13);
  const area_response three{{1, 3, {1, 1, 1}}, {1, 3, {1, 1, 1}}};
  EXPECT_FALSE(area_strength(std::vector{0.4, 0.2, 0.1}, three, 1, cells).known);
}

// error = f S on every path, f a parabola in dt, whose limit is found without error; a line finds another. Four levels
// are enough.
TEST(AreaStrength, LeavesOpenWhatALineWouldSayOtherwise) {
  constexpr int paths = 3, four = 4;
  const std::vector dt{0.25, 0.125, 0.0625, 0.03125};
  const auto f = [](double h) { return 0.1 + 0.8 * h + 0.3 * h * h; };
  area_response r{{paths, four, {}}, {paths, four, {}}};
  double area = 0;
  for (const double square : {0.9, 1.0, 1.2})
    for (const double h : dt) {
      area += square / paths / four;
      r.square.values.push_back(square * h);
      r.product.values.push_back(square * h * f(h));
    }
  const auto m = area_strength(dt, r, paths, cells);
  ASSERT_TRUE(m.known);
  const auto weights = constant_of_polynomial(dt, 1);
  double line = -0.1;
  for (int l = 0; l < four; ++l) line += weights[l] * f(dt[static_cast<std::size_t>(l)]);
  const double spread = std::sqrt(0.14 / 3) / paths / area;  // of 0.9, 1, 1.2 about 3.1 / 3
  const double open = left_open(dt, f(dt.back()) - 0.1, line, std::fabs(line) * spread);
  EXPECT_LT(open, 0.9 * std::fabs(line));  // as the corrections go on like those of a geometric series
  EXPECT_NEAR(m.error.value, 0.1, 1e-13);
  EXPECT_NEAR(m.error.high, 0.1 + open + 0.1 / cells, 1e-12);
  EXPECT_NEAR(m.error.low, 0.1 - open - 0.1 / cells, 1e-12);
  EXPECT_NEAR(m.sure, std::fabs(line) + 0.1 / cells, 1e-12);
  EXPECT_NEAR(m.size, std::sqrt(area * dt.back()), 1e-13);
}

}  // namespace
}  // namespace polhode
