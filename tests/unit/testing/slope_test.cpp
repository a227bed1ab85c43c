// SPDX-License-Identifier: Apache-2.0
// "This slope is p", and Wald's test.
#include <polhode/testing/slope_test.hpp>
#include <polhode/testing/sprt.hpp>

#include "kit.hpp"

namespace polhode::testkit_tests {
namespace {

using namespace testkit;

const std::vector<double> dt{0.25, 0.125, 0.0625, 0.03125, 0.015625};

std::vector<double> errors(double order, double further = 0) {
  std::vector<double> e;
  for (double h : dt) e.push_back(3 * std::pow(h, order) * (1 + further * h));
  return e;
}

TEST(SlopeTest, FalseAlarmsStayWithinTheBudget) {
  expect_within(alarms(21,
                       [](auto& bits) {
                         std::normal_distribution<double> normal(1, 0.05);
                         auto e = errors(1);
                         std::vector<double> se;
                         for (double& x : e) se.push_back(0.05 * x), x *= normal(bits);
                         return slope_test(dt, e, se, 1, 0, 0.05).kind() == verdict::refuted;
                       }),
                0.05);
}

/// Squared errors of paths which all levels share, but for a part.
std::vector<double> squares(random_bits& bits, double order, int paths) {
  std::normal_distribution<double> normal;
  std::vector<double> out;
  for (int p = 0; p < paths; ++p) {
    const double shared = normal(bits);
    for (double h : dt) out.push_back(std::pow(h, 2 * order) * std::pow(shared + 0.3 * normal(bits), 2));
  }
  return out;
}

TEST(SlopeTest, FalseAlarmsOfSharedPathsStayWithinTheBudget) {
  expect_within(alarms(22,
                       [](auto& bits) {
                         return slope_test::of_paths(dt, squares(bits, 1, 100), 2, 0, 0.05).kind() == verdict::refuted;
                       }),
                0.05);
}

TEST(SlopeTest, AHalfOrderClaimedAsOneIsRefuted) {
  random_bits bits(23);
  std::vector<double> se;
  for (double e : errors(0.5)) se.push_back(0.01 * e);
  const slope_test half(dt, errors(0.5), se, 1, 0.1, 1e-4);
  EXPECT_EQ(half.kind(), verdict::refuted) << half.reason();
  const auto paths = slope_test::of_paths(dt, squares(bits, 0.5, 3000), 2, 0.2, 1e-4);
  EXPECT_EQ(paths.kind(), verdict::refuted) << paths.reason();
  const auto healthy = slope_test::of_paths(dt, squares(bits, 1, 6000), 2, 0.2, 1e-4);
  EXPECT_TRUE(healthy.holds()) << healthy.reason();
}

TEST(SlopeTest, FitsByHand) {
  const std::vector<double> x{0, 1, 2}, y{0, 1, 5}, equal{1, 1, 1}, uneven{1, 2, 1};
  const line_fit plain(x, y, equal), weighted(x, y, uneven);
  EXPECT_NEAR(plain.slope, 2.5, 1e-14);
  EXPECT_NEAR(plain.variance, 0.5, 1e-14);
  EXPECT_NEAR(plain.chi2, 1.5, 1e-14);  // residuals 1/2, -1, 1/2
  EXPECT_NEAR(weighted.slope, 2.5, 1e-14);
  EXPECT_NEAR(weighted.chi2, 2.25, 1e-13);  // residuals 3/4, -3/4, 3/4
}

TEST(SlopeTest, TheIntervalHoldsTheOrderOfBentCurves) {
  for (std::size_t levels : {4u, 5u})
    for (double further : {-1.0, 0.3, 1.0, 2.0})
      for (double order : {0.5, 1.0, 2.0})
        for (double tilt : {-2.0, 0.0, 2.0}) {  // which end of the line is known best
          const std::span h(dt.data(), levels);
          const auto e = errors(order, further);
          std::vector<double> se;
          for (std::size_t i = 0; i < levels; ++i) se.push_back(1e-9 * e[i] * std::pow(h[i], tilt));
          for (const auto& known : {se, std::vector<double>{}}) {
            const slope_test t(h, {e.data(), levels}, known, order, 0, 0.01);
            EXPECT_LE(t.range().low, order) << t.reason() << ' ' << further << ' ' << tilt;
            EXPECT_GE(t.range().high, order) << t.reason() << ' ' << further << ' ' << tilt;
          }
        }
}

TEST(SlopeTest, BadErrors) {
  const std::vector<double> none, nan{1, 0.5, NAN, 0.1, 0.1}, zero{1, 0.5, 0.25, 0, 0}, equal(5, 1e-16), se(5, 0.2);
  EXPECT_EQ(slope_test(dt, nan, none, 1, 0.1, 0.01).kind(), verdict::refuted);
  EXPECT_EQ(slope_test(dt, zero, none, 1, 0.1, 0.01).kind(), verdict::inconclusive);
  EXPECT_EQ(slope_test(dt, equal, none, 1, 0.1, 0.01).kind(), verdict::refuted);
  EXPECT_TRUE(slope_test(dt, errors(1), none, 1, 0.1, 0.01).holds());
  const slope_test noisy(dt, errors(1), se, 1, 0.1, 0.01);
  EXPECT_EQ(noisy.kind(), verdict::inconclusive);
  EXPECT_NE(noisy.reason().find("times as many samples"), std::string::npos) << noisy.reason();
  EXPECT_EQ(slope_test::of_paths(dt, none, 1, 0.1, 0.01).kind(), verdict::inconclusive);
  EXPECT_THROW(slope_test({dt.data(), 3}, {equal.data(), 3}, none, 1, 0.1, 0.01), std::invalid_argument);
  EXPECT_THROW(slope_test(dt, equal, {se.data(), 2}, 1, 0.1, 0.01), std::invalid_argument);
  EXPECT_THROW(slope_test(equal, equal, none, 1, 0.1, 0.01), std::invalid_argument);
  EXPECT_THROW(slope_test(dt, equal, std::vector<double>(5), 1, 0.1, 0.01), std::invalid_argument);
  EXPECT_THROW(slope_test::of_paths(dt, {se.data(), 4}, 1, 0.1, 0.01), std::invalid_argument);
}

// Siegmund, Sequential Analysis (1985), section 3.5 and chapter X: of normal samples the boundaries move out by 0.583
// standard deviations; then the walk is Brownian motion.
TEST(Sprt, ErrorsAndSampleNumbersAreThoseOfTheory) {
  double samples = 0;
  const int count = alarms(31, [&](auto& bits) {
    std::normal_distribution<double> normal;
    auto t = sprt::normal({.claimed = 0, .other = 0.5, .alpha = 0.05, .beta = 0.05}, 1, 100000);
    fill(t, [&] { return normal(bits); });
    samples += static_cast<double>(t.samples()) / healthy_sets;
    return t.kind() == verdict::refuted;
  });
  const double bound = std::log(20.) + 0.583 * 0.5;
  const double theory = (1 - std::exp(-bound)) / (std::exp(bound) - std::exp(-bound));
  expect_within(count, 0.05);
  expect_rate(count, theory);
  EXPECT_NEAR(samples, bound * (1 - 2 * theory) / 0.125, 0.02 * samples);
}

TEST(Sprt, PassesOfADefectStayWithinTheirRate) {
  expect_within(alarms(32,
                       [](auto& bits) {
                         auto t = sprt::bernoulli({.claimed = 0.5, .other = 0.6, .alpha = 0.01, .beta = 0.05}, 100000);
                         std::bernoulli_distribution defect(0.6);
                         fill(t, [&] { return defect(bits); });
                         return t.holds();
                       }),
                0.05);
}

TEST(Sprt, BadSamples) {
  const simple_hypotheses h{.claimed = 0.5, .other = 0.6, .alpha = 0.01, .beta = 0.01};
  auto nan = sprt::bernoulli(h, 10), third = nan, open = nan, few = nan,
       never = sprt::bernoulli({0, 0.1, 0.01, 0.01}, 10);
  nan.add(NAN);
  third.add(0.3);
  fill(few, [&] { return static_cast<double>(few.samples() % 2); });
  never.add(1);  // what has probability 0
  EXPECT_EQ(nan.kind(), verdict::refuted);
  EXPECT_EQ(third.kind(), verdict::refuted);
  EXPECT_EQ(never.kind(), verdict::refuted) << never.reason();
  EXPECT_EQ(open.kind(), verdict::inconclusive);
  EXPECT_NE(open.reason().find("after 0 samples"), std::string::npos) << open.reason();
  EXPECT_EQ(few.kind(), verdict::inconclusive) << few.reason();
  EXPECT_FALSE(few.wants_more());
  EXPECT_THROW(sprt::bernoulli({0.5, 0.5, 0.01, 0.01}, 10), std::invalid_argument);
  EXPECT_THROW(sprt::bernoulli({0.5, 1.5, 0.01, 0.01}, 10), std::invalid_argument);
  EXPECT_THROW(sprt::normal(h, 0, 10), std::invalid_argument);
  EXPECT_THROW(sprt::normal(h, 1, 0), std::invalid_argument);
}

}  // namespace
}  // namespace polhode::testkit_tests
