// SPDX-License-Identifier: Apache-2.0
// "This sample's mean is m": rates of false alarms, planted defects, bad samples.
#include <polhode/testing/bounded_mean_test.hpp>
#include <polhode/testing/mean_test.hpp>

#include <numeric>

#include "kit.hpp"

namespace polhode::testkit_tests {
namespace {

using namespace testkit;

/// P(|Z_k| > z at any of the looks), Z_k = B(n_k) / sqrt n_k, n_k doubling: the density of B among those not yet
/// alarmed, taken from look to look by the midpoint rule (Armitage, McPherson, Rowe 1969).
double alarm_probability(double z, int looks) {
  const int cells = 400;
  const auto normal = [](double x, double variance) {
    return std::exp(-x * x / (2 * variance)) / std::sqrt(2 * M_PI * variance);
  };
  std::vector<double> at, density;
  double n = 1, alive = 0;
  for (int k = 0; k < looks; ++k, n *= 2) {
    const double width = 2 * z * std::sqrt(n) / cells;
    std::vector<double> next_at, next;
    for (int i = 0; i < cells; ++i) {
      const double x = (i + 0.5) * width - z * std::sqrt(n);
      double sum = k == 0 ? normal(x, 1) : 0;
      for (std::size_t j = 0; j < at.size(); ++j) sum += density[j] * normal(x - at[j], n / 2);
      next_at.push_back(x), next.push_back(sum);
    }
    at = next_at, density = next;
    alive = std::accumulate(density.begin(), density.end(), 0.0) * width;
    for (double& d : density) d *= width;
  }
  return 1 - alive;
}

/// An alarm at any look counts, as of somebody who watches.
template <class Test, class Draw>
bool watched(Test t, Draw draw) {
  bool alarm = false;
  while (t.wants_more()) {
    t.add(draw());
    alarm = alarm || t.kind() == verdict::refuted;
  }
  return alarm;
}

constexpr sampling short_plan{.first = 32, .most = 1024};  // six looks

TEST(MeanTest, FalseAlarmsOfNormalSamplesAreThoseOfTheory) {
  EXPECT_NEAR(alarm_probability(polhode::normal_deviate(0.025), 1), 0.05, 1e-5);
  const double theory = alarm_probability(polhode::normal_deviate(0.025 / 6), 6);
  EXPECT_GT(theory, 0.03);  // little of the budget is lost to Bonferroni
  EXPECT_LT(theory, 0.05);
  expect_rate(alarms(1,
                     [](auto& bits) {
                       std::normal_distribution<double> normal(3, 2);
                       return watched(mean_test(3, 0, 0.05, short_plan), [&] { return normal(bits); });
                     }),
              theory);
}

TEST(MeanTest, SkewSamplesStayWithinTheBudget) {
  expect_within(alarms(2,
                       [](auto& bits) {
                         std::exponential_distribution<double> exponential(1);
                         return watched(mean_test(1, 0, 0.05, short_plan), [&] { return exponential(bits); });
                       }),
                0.05);
}

TEST(BoundedMeanTest, FalseAlarmsStayWithinTheBudget) {
  expect_within(alarms(3,
                       [](auto& bits) {  // the widest law between the bounds
                         return watched(bounded_mean_test(0.5, 0, 0.05, {0, 1}, short_plan),
                                        [&] { return static_cast<double>(bits() >> 63); });
                       }),
                0.05);
}

TEST(MeanTest, OnePerCentOffIsRefutedAndHealthyHolds) {
  random_bits bits(4);
  for (int i = 0; i < 25; ++i) {
    std::normal_distribution<double> normal(0, 0.1);
    mean_test healthy(1, 0.005, 1e-4), off(1, 0.005, 1e-4);
    fill(healthy, [&] { return 1 + normal(bits); });
    fill(off, [&] { return 1.01 + normal(bits); });
    EXPECT_TRUE(healthy.holds()) << healthy.reason();
    EXPECT_EQ(off.kind(), verdict::refuted) << off.reason();
    EXPECT_LE((healthy.at_last_look().high - healthy.at_last_look().low) / 2, 0.0025);
  }
}

TEST(BoundedMeanTest, OnePerCentOffIsRefutedAndHealthyHolds) {
  random_bits bits(5);
  for (int i = 0; i < 5; ++i) {
    std::uniform_real_distribution<double> uniform(0, 1);
    bounded_mean_test healthy(0.5, 0.005, 1e-4, {0, 1.01}), off(0.5, 0.005, 1e-4, {0, 1.01});
    fill(healthy, [&] { return uniform(bits); });
    fill(off, [&] { return 0.01 + uniform(bits); });
    EXPECT_TRUE(healthy.holds()) << healthy.reason();
    EXPECT_EQ(off.kind(), verdict::refuted) << off.reason();
  }
}

TEST(MeanTest, IntervalsByHand) {
  const std::vector<double> samples{0, 0, 1, 1};  // mean 1/2, variance 1/3
  mean_test student(0.5, 1, 0.05, {.first = 4, .most = 4});
  student.add(samples);
  EXPECT_NEAR(student.at_last_look().high, 0.5 + 3.182446305 / std::sqrt(12.), 1e-8);  // t_3 of tables
  bounded_mean_test bounded(0.5, 1, 0.05, {0, 1}, {.first = 4, .most = 4});
  bounded.add(samples);
  EXPECT_NEAR(bounded.at_last_look().high, 0.5 + std::sqrt(std::log(80.) / 8), 1e-14);
  bounded_mean_test narrow(0.5, 0.1, 0.05, {0, 1}, {.first = 1000, .most = 1000});
  fill(narrow, [] { return 0.5; });
  EXPECT_NEAR(narrow.at_last_look().high, 0.5 + 7 * std::log(160.) / 2997, 1e-14);
  EXPECT_TRUE(narrow.holds()) << narrow.reason();
}

TEST(MeanTest, LooksAreFixedAndBatchesChangeNothing) {
  EXPECT_EQ((sampling{100, 100}.looks()), 1);
  EXPECT_EQ((sampling{100, 801}.looks()), 5);  // 100, 200, 400, 800, 801
  random_bits bits(6);
  std::normal_distribution<double> normal;
  std::vector<double> samples(5000);
  for (auto& x : samples) x = normal(bits);
  mean_test whole(0, 0.2, 0.01), single(0, 0.2, 0.01);
  whole.add(samples);
  for (double x : samples) single.add(x);
  EXPECT_EQ(whole.reason(), single.reason());
  EXPECT_EQ(whole.samples(), 2048u);  // (3.385 / 0.1)^2 = 1146 are wanted: the next look, and no sample later
}

TEST(MeanTest, NothingIsConcludedFromTooLittle) {
  mean_test none(0, 1, 0.01);
  EXPECT_EQ(none.kind(), verdict::inconclusive);
  EXPECT_NE(none.reason().find("(128)"), std::string::npos);
  random_bits bits(7);
  std::normal_distribution<double> normal;
  mean_test point(0, 0, 0.01, {.first = 32, .most = 64}), edge(0, 1, 0.01),
      short_of(0, 0.01, 0.01, {.first = 32, .most = 64});
  fill(point, [&] { return normal(bits); });
  fill(edge, [&] { return 1 + normal(bits); });
  fill(short_of, [&] { return normal(bits); });
  for (const auto* t : {&point, &edge, &short_of}) EXPECT_EQ(t->kind(), verdict::inconclusive) << t->reason();
  EXPECT_NE(point.reason().find("a margin of 0"), std::string::npos) << point.reason();
  EXPECT_NE(edge.reason().find("edge"), std::string::npos) << edge.reason();
  EXPECT_NE(short_of.reason().find("more samples"), std::string::npos) << short_of.reason();
}

TEST(MeanTest, HeavyTailsAreNotTrusted) {
  random_bits bits(8);
  std::cauchy_distribution<double> cauchy;
  mean_test t(0, 0.1, 0.01, {.first = 128, .most = 4096});
  fill(t, [&] { return std::fabs(cauchy(bits)); });
  EXPECT_EQ(t.kind(), verdict::inconclusive);
  EXPECT_NE(t.reason().find("skewness"), std::string::npos) << t.reason();
}

TEST(MeanTest, BadSamplesAreRefuted) {
  for (double bad : {NAN, INFINITY, -INFINITY}) {
    mean_test t(0, 1, 0.01);
    bounded_mean_test b(0, 1, 0.01, {-1, 1});
    t.add(0.5), t.add(bad), t.add(0.5);
    b.add(0.5), b.add(bad);
    EXPECT_EQ(t.kind(), verdict::refuted);
    EXPECT_EQ(b.kind(), verdict::refuted);
    EXPECT_FALSE(t.wants_more());
    EXPECT_NE(t.reason().find("sample 2 is"), std::string::npos) << t.reason();
  }
  mean_test right(0.1, 0.01, 0.01, {.first = 8, .most = 16}), wrong(0.2, 0.01, 0.01, {.first = 8, .most = 16});
  fill(right, [] { return 0.1; });
  fill(wrong, [] { return 0.1; });
  EXPECT_EQ(right.kind(), verdict::inconclusive) << right.reason();
  EXPECT_EQ(wrong.kind(), verdict::refuted) << wrong.reason();
}

TEST(MeanTest, WhatCannotBeMeantIsThrown) {
  EXPECT_THROW(mean_test(NAN, 1, 0.01), std::invalid_argument);
  EXPECT_THROW(mean_test(0, -1, 0.01), std::invalid_argument);
  EXPECT_THROW(mean_test(0, 1, 0), std::invalid_argument);
  EXPECT_THROW(mean_test(0, 1, 0.01, {.first = 1, .most = 8}), std::invalid_argument);
  EXPECT_THROW(mean_test(0, 1, 0.01, {.first = 16, .most = 8}), std::invalid_argument);
  EXPECT_THROW(bounded_mean_test(0, 1, 0.01, {1, 1}), std::invalid_argument);
}

}  // namespace
}  // namespace polhode::testkit_tests
