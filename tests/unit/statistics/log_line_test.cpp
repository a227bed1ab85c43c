// SPDX-License-Identifier: Apache-2.0
// The line through levels against a least-squares solver, the levels that are chosen for it, and their norms.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <string>
#include <vector>

#include "statistics/orders/level_choice.hpp"
#include "statistics/orders/log_line.hpp"
#include "statistics/orders/squared_errors.hpp"
#include "support/dense.hpp"

namespace polhode {
namespace {

const std::vector<log_level> scattered{
    {0, 0.5, -1.1, 0.2}, {1, -0.5, -1.9, 0.1}, {2, -1.4, -3.2, 0.15}, {3, -2.5, -4.0, 0.05}, {4, -3.6, -4.7, 0.4}};

log_line by_solver(const std::vector<log_level>& levels) {
  Eigen::MatrixXd design(levels.size(), 2);
  Eigen::VectorXd value(levels.size());
  for (Eigen::Index i = 0; i < value.size(); ++i) {
    const auto& l = levels[static_cast<std::size_t>(i)];
    const double error = l.error > 0 ? l.error : 1;
    design.row(i) << 1 / error, l.x / error;
    value[i] = l.y / error;
  }
  const Eigen::Vector2d c = test::least_squares_of(design, value);
  return {c[0], c[1]};
}

std::vector<log_level> without_errors(std::vector<log_level> levels) {
  for (auto& l : levels) l.error = 0;
  return levels;
}

TEST(LogLine, IsThatOfLeastSquaresWithOrWithoutErrors) {
  for (const auto& levels : {scattered, without_errors(scattered)}) {
    const auto found = line_through(levels), expected = by_solver(levels);
    EXPECT_NEAR(found.slope, expected.slope, 1e-13);
    EXPECT_NEAR(found.intercept, expected.intercept, 1e-13);
    EXPECT_NEAR(found.at(3), expected.intercept + 3 * expected.slope, 1e-13);
  }
}

// A billion times as well as the others: the line turns about it. Only squares of deviations from the mean bear the
// mean's own rounding under such a weight.
TEST(LogLine, GoesThroughALevelThatIsKnownFarBetter) {
  auto levels = scattered;
  levels[2] = {2, -1.3, -2.9, 1e-10};
  double along = 0, across = 0;
  for (const auto& l : levels) {
    along += l.weight() * std::pow(l.x + 1.3, 2);
    across += l.weight() * (l.x + 1.3) * (l.y + 2.9);
  }
  const auto line = line_through(levels);
  EXPECT_NEAR(line.slope, across / along, 1e-11);
  EXPECT_NEAR(line.at(-1.3), -2.9, 1e-12);
}

TEST(LogLine, TheCoarsestLevelIsComparedWithTheLineThroughTheOthers) {
  const std::vector<log_level> rest(scattered.begin() + 1, scattered.end());
  EXPECT_NEAR(off_the_others(scattered), -1.1 - by_solver(rest).at(0.5), 1e-13);
  EXPECT_NEAR(slope_at_the_finest(scattered), (-4.7 + 4.0) / (-3.6 + 2.5), 1e-13);
}

// Of three degrees of freedom: 3.182446305284263 standard errors.
TEST(LogLine, ScatterGivesStudentsInterval) {
  const auto levels = without_errors(scattered);
  const auto line = by_solver(levels);
  Eigen::MatrixXd design(levels.size(), 2);
  double residual = 0;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    design.row(static_cast<Eigen::Index>(i)) << 1, levels[i].x;
    residual += std::pow(levels[i].y - line.at(levels[i].x), 2);
  }
  const Eigen::Matrix2d covariance = residual / 3 * (design.transpose() * design).inverse();
  EXPECT_NEAR(half_width_of_scatter(levels, line), 3.182446305284263 * std::sqrt(covariance(1, 1)), 1e-12);
}

/// Levels x = 0, -1, …, on a line of slope 1, of which the coarsest lies off it.
std::vector<log_level> straight_but_for_the_first(int count, double off, double error) {
  std::vector<log_level> out;
  for (int i = 0; i < count; ++i) out.push_back({i, -1.0 * i, -1.0 * i + (i == 0 ? off : 0), error});
  return out;
}

TEST(LevelChoice, ALevelOffTheLineIsLeftOutWhereItsErrorDoesNotExplainIt) {
  const auto left = [](int count, double off, double error) {
    return asymptotic_part(straight_but_for_the_first(count, off, error)).size();
  };
  EXPECT_EQ(left(6, 0.051, 0.001), 5u);
  EXPECT_EQ(left(6, -0.051, 0.001), 5u);
  EXPECT_EQ(left(6, 0.049, 0.001), 6u);
  EXPECT_EQ(left(6, 0.31, 0.1), 5u);
  EXPECT_EQ(left(6, 0.29, 0.1), 6u);
  EXPECT_EQ(left(5, 1, 0.1), 4u);
  EXPECT_EQ(left(4, 1, 0.1), 4u);  // no fewer
}

TEST(LevelChoice, TheFinestSixWhateverTheirOrder) {
  auto levels = straight_but_for_the_first(8, 0, 0.1);
  levels[2].y += 1;  // the coarsest of the six
  std::swap(levels[0], levels[5]);
  const auto chosen = choose_levels(levels, 2);
  ASSERT_EQ(chosen.finest.size(), 6u);
  ASSERT_EQ(chosen.levels.size(), 5u);
  for (int i = 0; i < 6; ++i) EXPECT_EQ(chosen.finest[static_cast<std::size_t>(i)].index, i + 2);
  EXPECT_EQ(chosen.levels.front().index, 3);
  EXPECT_EQ(
      chosen.rule,
      "5 levels used; left out: 2 coarser than the finest 6, 1 pre-asymptotic, 2 at the rounding floor or not finite");
}

TEST(LevelChoice, FewLevelsOrAllOfThem) {
  const auto three = straight_but_for_the_first(3, 1, 0.1);
  EXPECT_EQ(choose_levels(three, 0).levels.size(), 3u);
  const auto nine = straight_but_for_the_first(9, 1, 0.1);
  EXPECT_EQ(every_level(nine).levels.size(), 9u);
  EXPECT_EQ(every_level(nine).finest.size(), 9u);
}

// Errors 1, 2, 3, 6 at level 1 of two.
const squared_errors four{4, 2, {100, 1, 100, 4, 100, 9, 100, 36}};

TEST(SquaredErrors, MeanAndItsStandardError) {
  const auto m = level_mean(four, 1);
  EXPECT_NEAR(m.mean, 12.5, 1e-13);
  EXPECT_NEAR(m.error, std::sqrt((11.5 * 11.5 + 8.5 * 8.5 + 3.5 * 3.5 + 23.5 * 23.5) / 3 / 4), 1e-13);
  EXPECT_EQ(level_mean(four, 0).error, 0);
  EXPECT_EQ(level_mean({1, 1, {7}}, 0).mean, 7);
  EXPECT_EQ(level_mean({1, 1, {7}}, 0).error, 0);
}

TEST(SquaredErrors, NormsOfAnyPower) {
  for (const double p : {1.0, 2.0, 3.0, 4.0}) {
    double sum = 0, square = 0;
    for (const double e : {1, 2, 3, 6}) sum += std::pow(e, p) / 4, square += std::pow(e, 2 * p) / 4;
    const auto found = level_norm(four, p, 1);
    EXPECT_NEAR(found.mean, std::pow(sum, 1 / p), 1e-13) << p;
    const double error = std::sqrt((square - sum * sum) / 3);  // of the mean of |e|^p
    EXPECT_NEAR(found.error, std::pow(sum, 1 / p - 1) / p * error, 1e-12) << p;
    EXPECT_NEAR(raised(four, p).at(3, 1), std::pow(6, p), 1e-10) << p;
  }
  const squared_errors none{2, 1, {0, 0}};
  EXPECT_EQ(level_norm(none, 2, 0).mean, 0);
  EXPECT_EQ(level_norm(none, 2, 0).error, 0);
}

// A level at the limit itself is not off the line: by 0.05 without error, by three errors of 1/8.
TEST(LevelChoice, ALevelAtTheLimitStays) {
  std::vector<log_level> flat(5);
  for (int i = 0; i < 5; ++i) flat[static_cast<std::size_t>(i)] = {i, -1.0 * i, i == 0 ? 0.05 : 0, 0};
  EXPECT_EQ(asymptotic_part(flat).size(), 5u);
  flat[0].y = std::nextafter(0.05, 1);
  EXPECT_EQ(asymptotic_part(flat).size(), 4u);
  auto sampled = straight_but_for_the_first(5, 0.375, 0.125);
  EXPECT_EQ(asymptotic_part(sampled).size(), 5u);
  sampled[0].y = std::nextafter(0.375, 1);
  EXPECT_EQ(asymptotic_part(sampled).size(), 4u);
}

// Squares 1/16 and 9/16 of two paths: mean 5/16, standard error 1/4.
TEST(SquaredErrors, OfTwoPathsAndBelowOne) {
  const squared_errors two{2, 1, {1 / 16.0, 9 / 16.0}};
  EXPECT_DOUBLE_EQ(level_mean(two, 0).mean, 5 / 16.0);
  EXPECT_DOUBLE_EQ(level_mean(two, 0).error, 0.25);
  EXPECT_DOUBLE_EQ(level_norm(two, 2, 0).error, 0.25 / (2 * std::sqrt(5 / 16.0)));
  EXPECT_DOUBLE_EQ(raised(two, 5).values[1], std::pow(0.75, 5));
}

}  // namespace
}  // namespace polhode
