// SPDX-License-Identifier: Apache-2.0
// Sampled errors as powers of the step: a wrong limit, and a leading term below a larger one.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include <polhode/noise/normal.hpp>

#include "statistics/orders/order_fit.hpp"
#include "statistics/resample.hpp"
#include "statistics/resampled_means.hpp"
#include "support/dense.hpp"
#include "support/halvings.hpp"

namespace polhode {
namespace {

using test::halvings;

squared_errors noisy_errors(const std::vector<double>& dt, double order, double offset, std::uint64_t seed, int paths) {
  squared_errors e{paths, static_cast<int>(dt.size()), {}};
  for (int path = 0; path < paths; ++path) {
    const auto z = normals<2>({seed, noise_kind::increment, static_cast<std::uint64_t>(path), 0});
    for (const double h : dt)
      e.values.push_back(std::pow(h, 2 * order) * (z[0] * z[0] + z[1] * z[1]) + offset * offset);
  }
  return e;
}

TEST(ErrorModel, TellsAWrongLimitFromARightOne) {
  const auto dt = halvings(6);
  const std::vector<bool> used(6, true);
  EXPECT_LT(fit_error_model(dt, noisy_errors(dt, 0.5, 0, 1, 500), used, 0.5, 1).limit.high, 0.02);
  const auto wrong = fit_error_model(dt, noisy_errors(dt, 0.5, 0.3, 1, 500), used, 0.5, 1).limit;
  EXPECT_GT(wrong.low, 0.25);
  EXPECT_NEAR(wrong.value, 0.3, 0.02);
}

// Order 1/2 hidden under a larger term of order 1: the slope does not show it, the leading coefficient does.
TEST(ErrorModel, FindsALeadingTermBelowALargerOne) {
  const auto dt = halvings(6);
  const std::vector<bool> used(6, true);
  squared_errors hidden = noisy_errors(dt, 1.0, 0, 1, 500), pure = hidden;
  for (int path = 0; path < hidden.paths; ++path)
    for (int l = 0; l < hidden.levels; ++l) hidden.at(path, l) += 0.02 * dt[static_cast<std::size_t>(l)];
  EXPECT_GT(fit_order(dt, hidden, 0, 1)->low, 0.6);
  EXPECT_NEAR(fit_error_model(dt, hidden, used, 0.5, 1).leading.value, 0.02, 2e-3);
  EXPECT_GT(fit_error_model(dt, hidden, used, 0.5, 1).leading.low, 0);
  EXPECT_LE(fit_error_model(dt, pure, used, 0.5, 1).leading.low, 1e-9);
}

// dt^2 under dt^4, and dt^4 alone: three powers tell them apart, two take the misfit for a negative leading term.
TEST(ErrorModel, ThreePowersFindATermFarBelowTheSlope) {
  const auto dt = halvings(6);
  const std::vector<bool> used(6, true);
  squared_errors with{500, 6, {}}, alone = with;
  for (int path = 0; path < 500; ++path) {
    const auto z = normals<2>({3, noise_kind::increment, static_cast<std::uint64_t>(path), 0});
    const double size = z[0] * z[0] + z[1] * z[1];
    for (const double h : dt) {
      with.values.push_back(size * (1e-5 * h * h + std::pow(h, 4)));
      alone.values.push_back(size * std::pow(h, 4));
    }
  }
  EXPECT_GT(fit_error_model(dt, with, used, 1, 1, 3).leading.low, 1.5e-5);
  EXPECT_LE(fit_error_model(dt, alone, used, 1, 1, 3).leading.low, 1e-12);
  EXPECT_LT(fit_error_model(dt, with, used, 1, 1, 2).leading.high, 0);
}

// The normal equations of squares over their standard errors, written out.
TEST(ErrorModel, IsTheWeightedLeastSquares) {
  const auto dt = halvings(6);
  const std::vector<bool> used{true, true, false, true, true, true};
  const double order = 0.5;
  const auto e = noisy_errors(dt, 0.7, 0.1, 5, 300);
  for (const int powers : {2, 3}) {
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(1 + powers, 1 + powers);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(1 + powers);
    for (int l = 0; l < 6; ++l) {
      if (!used[static_cast<std::size_t>(l)]) continue;
      double mean = 0, square = 0;
      for (int path = 0; path < e.paths; ++path) mean += e.at(path, l) / e.paths;
      for (int path = 0; path < e.paths; ++path) square += std::pow(e.at(path, l) - mean, 2);
      const double variance = square / (e.paths - 1) / e.paths, h = dt[static_cast<std::size_t>(l)];
      Eigen::VectorXd row(1 + powers);
      row[0] = 1;
      for (int i = 0; i < powers; ++i) row[1 + i] = std::pow(h, 2 * order + i);
      normal += row * row.transpose() / variance;
      right += row * mean / variance;
    }
    const auto found = fit_error_model(dt, e, used, order, 1, powers);
    const Eigen::VectorXd limited = test::solution_of(normal.topLeftCorner(3, 3), right.head(3)),
                          free = test::solution_of(normal.bottomRightCorner(powers, powers), right.tail(powers));
    EXPECT_NEAR(found.limit.value, std::sqrt(std::max(0.0, limited[0])), 1e-9);
    EXPECT_NEAR(found.leading.value, free[0], 1e-9 * std::fabs(free[0]));
    EXPECT_LT(found.leading.low, found.leading.value);
    EXPECT_GT(found.leading.high, found.leading.value);
  }
}

// Of 164 paths the interval ends at a replicate next to which a wider or a shorter one would begin.
TEST(ErrorModel, IntervalsAreThoseOfTheReplicatesLeastSquares) {
  const std::vector<double> dt{0.31, 0.17, 0.08, 0.045, 0.02, 0.011};
  constexpr int paths = 164;
  auto e = noisy_errors(dt, 0.7, 0.3, 5, paths);
  for (std::size_t i = 0; i < e.values.size(); ++i)
    e.values[i] += 0.01 * std::exp(normals<1>({6, noise_kind::increment, i, 0})[0]);
  const auto means = resampled_means(matrix_of(e), 4);
  std::vector<double> limits, leading;
  for (Eigen::Index r = 0; r < means.rows(); ++r) {
    Eigen::MatrixXd design(6, 3);
    Eigen::VectorXd right(6);
    for (int l = 0; l < 6; ++l) {
      const double h = dt[static_cast<std::size_t>(l)], error = level_mean(e, l).error;
      design.row(l) << 1 / error, std::pow(h, 1.4) / error, std::pow(h, 2.4) / error;
      right[l] = means(r, l) / error;
    }
    limits.push_back(test::least_squares_of(design, right)[0]);
    leading.push_back(test::least_squares_of(design.rightCols(2), right)[0]);
  }
  const auto [low, high] = bootstrap_interval(limits, 0.95, paths);
  const auto [least, most] = bootstrap_interval(leading, 0.95, paths);
  const auto found = fit_error_model(dt, e, std::vector<bool>(6, true), 0.7, 4);
  ASSERT_GT(low, 0);
  EXPECT_NEAR(found.limit.low, std::sqrt(low), 1e-11);
  EXPECT_NEAR(found.limit.high, std::sqrt(high), 1e-11);
  EXPECT_NEAR(found.leading.low, least, 1e-10);
  EXPECT_NEAR(found.leading.high, most, 1e-10);
}

// Three paths that are one: 1/4 + 3 dt^2 + 2 dt^3, and nothing but 3 dt^2 + 2 dt^3, or nothing at all at a level.
TEST(ErrorModel, LevelsWithoutScatterAreKnownWellAndNotWithoutEnd) {
  const std::vector<double> dt{0.125, 0.0625, 0.03125, 0.015625, 0.0078125};
  const std::vector<bool> used(5, true);
  squared_errors e{3, 5, {}};
  for (int path = 0; path < 3; ++path)
    for (const double h : dt) e.values.push_back(0.25 + h * h * (3 + 2 * h));
  EXPECT_NEAR(fit_error_model(dt, e, used, 1, 1).limit.value, 0.5, 1e-9);
  for (double& x : e.values) x -= 0.25;
  EXPECT_NEAR(fit_error_model(dt, e, used, 1, 1).leading.value, 3, 1e-9);
  for (int path = 0; path < 3; ++path) e.at(path, 4) = 0;
  EXPECT_TRUE(std::isfinite(fit_error_model(dt, e, used, 1, 1).limit.value));
  for (double& x : e.values) x = 0;
  EXPECT_EQ(fit_error_model(dt, e, used, 1, 1).limit.high, 0);
}

// Least squares by hand: each level weighs by its mean, that of zeros as the best of the others.
TEST(ErrorModel, LevelsWithoutScatterWeighByTheirMeans) {
  const std::vector<double> dt{0.31, 0.17, 0.08, 0.045, 0.02};
  for (const double last : {0.05, 0.0}) {
    const std::vector<double> mean{0.9, 0.31, 0.12, 0.06, last};
    squared_errors e{2, 5, {}};
    for (int path = 0; path < 2; ++path) e.values.insert(e.values.end(), mean.begin(), mean.end());
    Eigen::MatrixXd design(5, 3);
    Eigen::VectorXd right(5);
    for (Eigen::Index l = 0; l < 5; ++l) {
      const double h = dt[static_cast<std::size_t>(l)], m = mean[static_cast<std::size_t>(l)];
      const double error = m > 0 ? m : 0.06;
      design.row(l) << 1 / error, h / error, h * h / error;
      right[l] = m / error;
    }
    const double square = test::least_squares_of(design, right)[0];
    const double found = fit_error_model(dt, e, std::vector<bool>(5, true), 0.5, 1).limit.value;
    EXPECT_NEAR(found, square > 0 ? std::sqrt(square) : 0, 1e-10) << square;
    EXPECT_EQ(square > 0, last > 0) << square;
  }
}

}  // namespace
}  // namespace polhode
