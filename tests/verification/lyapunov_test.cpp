// SPDX-License-Identifier: Apache-2.0
// The rows of the experiment `lyapunov`, read back as a user would and held to the exponents at those places.
#include "sphere/lyapunov.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "support/verdicts.hpp"

namespace polhode {
namespace {

std::vector<report::measurement> rows(std::string_view quantity) {
  static const auto all = [] {
    // Sampled exponents: lyapunov_sampled_test.cpp.
    return test::quick_results(load_scene("paper"), {"lyapunov"}, {"euler_maruyama"}).measurements;
  }();
  std::vector<report::measurement> found;
  for (const auto& m : all)
    if (m.quantity == quantity && m.scheme.empty()) found.push_back(m);
  return found;
}

/// Sharper than the experiment's own.
lyapunov_exponents at(double sigma, double theta) {
  return lyapunov(body_on_sphere({1, 2, 3}, theta, 1, sigma * sigma * Eigen::Matrix3d::Identity()), 1e-7);
}

struct place {
  double sigma = 0, theta = 0;
};
place place_of(const report::measurement& m, std::size_t wanted) {
  EXPECT_EQ(m.at.size(), wanted);
  return {m.at_coordinate("sigma").value_or(NAN), m.at_coordinate("theta").value_or(NAN)};
}

std::optional<double> border_at(double sigma) {
  for (const auto& m : rows("border of chaos"))
    if (place_of(m, 1).sigma == sigma) return m.value;
  return std::nullopt;
}

TEST(LyapunovRows, AreTheExponentsOfTheScene) {
  const auto found = lyapunov(body_on_sphere({1, 2, 3}, 0.5, 1, 0.25 * Eigen::Matrix3d::Identity()), 1e-10);
  ASSERT_EQ(found.reason, "");
  const auto first = rows("lambda_1"), sum = rows("lambda_1 + lambda_2"), dimension = rows("kaplan_yorke_dimension");
  ASSERT_EQ(first.size() * sum.size() * dimension.size(), 1u);
  const std::vector<std::pair<report::measurement, double>> expected{
      {first[0], *found.lambda1}, {sum[0], found.sum}, {dimension[0], found.dimension}};
  for (const auto& [m, value] : expected) {
    EXPECT_LE(*m.low, value) << m.quantity;
    EXPECT_GE(*m.high, value) << m.quantity;
    EXPECT_LT(*m.high - *m.low, 2e-6) << m.quantity;
    EXPECT_EQ(m.status, "ok");
    EXPECT_EQ(m.method, "exact");
  }
  EXPECT_NEAR(*first[0].value, 0.020196, 6e-7);  // docs/model.md, section 5
}

// docs/model.md, section 5: at sigma = 1/2 the sign changes between theta = 1/2 and 1.
TEST(LyapunovRows, OnTheBorderTheExponentVanishesAndChangesItsSign) {
  int found = 0;
  for (const auto& m : rows("border of chaos")) {
    if (!m.value) continue;
    ++found;
    const double sigma = place_of(m, 1).sigma;
    const auto on = at(sigma, *m.value), below = at(sigma, 0.98 * *m.value), above = at(sigma, 1.02 * *m.value);
    ASSERT_TRUE(on.lambda1 && below.lambda1 && above.lambda1) << sigma;
    const double slope = (*above.lambda1 - *below.lambda1) / (0.04 * *m.value);
    EXPECT_LE(std::fabs(*on.lambda1), 0.5 * (*m.high - *m.low) * std::fabs(slope) + on.uncertainty) << sigma;
    EXPECT_LT(*m.high - *m.low, 2e-3 * *m.value) << sigma;
    EXPECT_GT(*below.lambda1, below.uncertainty) << sigma;
    EXPECT_LT(*above.lambda1, -above.uncertainty) << sigma;
    EXPECT_GT(*m.value, sigma < 0.4 ? 0.05 : 0.5) << sigma;
    EXPECT_LT(*m.value, 1) << sigma;
  }
  EXPECT_EQ(found, 6);
}

TEST(LyapunovRows, TheMapHasTheSignsThatTheBorderDraws) {
  int positive = 0, negative = 0;
  for (const auto& m : rows("lambda_1 map")) {
    const auto p = place_of(m, 2);
    ASSERT_TRUE(m.value) << m.observable;
    const auto border = border_at(p.sigma);
    ASSERT_TRUE(border) << p.sigma;
    ++(p.theta < *border ? positive : negative);
    EXPECT_EQ(*m.low > 0, p.theta < *border) << m.observable;
    EXPECT_EQ(*m.high<0, p.theta> * border) << m.observable;
  }
  EXPECT_EQ(positive + negative, 36);
  EXPECT_GE(std::min(positive, negative), 6);
}

TEST(LyapunovRows, TheMapIsRightAtItsPlaces) {
  const auto map = rows("lambda_1 map");
  ASSERT_EQ(map.size(), 36u);
  for (std::size_t i = 0; i < map.size(); i += 7) {
    const auto p = place_of(map[i], 2);
    const auto sharp = at(p.sigma, p.theta);
    EXPECT_NEAR(*map[i].value, *sharp.lambda1, 1e-4) << map[i].observable;
  }
}

}  // namespace
}  // namespace polhode
