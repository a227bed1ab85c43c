// SPDX-License-Identifier: Apache-2.0
// "This law is that law", and a budget over a suite of such.
#include <polhode/testing/alarm_budget.hpp>
#include <polhode/testing/law_test.hpp>
#include <polhode/testing/quantiles.hpp>

#include "kit.hpp"

namespace polhode::testkit_tests {
namespace {

using namespace testkit;

double uniform_cdf(double x) { return std::min(1.0, std::max(0.0, x)); }

double uniform(random_bits& bits) { return static_cast<double>(bits() >> 11) * 0x1p-53; }

bool refuted(random_bits& bits, double alpha, std::size_t samples) {
  law_test t(uniform_cdf, 0, alpha, samples);
  fill(t, [&] { return uniform(bits); });
  return t.kind() == verdict::refuted;
}

/// P(D_n > e): Kolmogorov's limit with Stephens's correction (J. Roy. Stat. Soc. B 32 (1970) 115-122).
double kolmogorov_tail(double e, double n) {
  const double t = e * (std::sqrt(n) + 0.12 + 0.11 / std::sqrt(n));
  return 2 * std::exp(-2 * t * t) - 2 * std::exp(-8 * t * t);
}

TEST(LawTest, FalseAlarmsAreThoseOfTheory) {
  const double theory = kolmogorov_tail(dkw_half_width(300, 0.05), 300);
  EXPECT_GT(theory, 0.045);  // the bound loses next to nothing
  expect_rate(alarms(11, [](auto& bits) { return refuted(bits, 0.05, 300); }), theory);
}

TEST(LawTest, ASuiteOfFiveKeepsItsOneBudget) {
  const int count = alarms(12, [](auto& bits) {
    alarm_budget budget(0.05);
    bool any = false;
    for (int k = 0; k < 5; ++k) any = refuted(bits, budget.next(), 60) || any;
    return any;
  });
  double healthy = 1;
  for (int k = 1; k <= 5; ++k) healthy *= 1 - kolmogorov_tail(dkw_half_width(60, alarm_budget(0.05).share(k)), 60);
  expect_within(count, 0.05);
  expect_rate(count, 1 - healthy);
}

TEST(TwoLawTest, FalseAlarmsStayWithinTheBudget) {
  expect_within(alarms(13,
                       [](auto& bits) {
                         std::vector<double> a(100), b(200);
                         for (auto& x : a) x = uniform(bits);
                         for (auto& x : b) x = uniform(bits);
                         return two_law_test(a, b, 0, 0.05).kind() == verdict::refuted;
                       }),
                0.05);
}

TEST(LawTest, DistancesByHand) {
  law_test t(uniform_cdf, 0.5, 0.05, 3);
  t.add(std::vector{0.9, 0.1, 0.4});  // distance 2/3 - 0.4
  const double e = std::sqrt(std::log(40.) / 6);
  EXPECT_EQ(t.reason(), text("distance %.4g [%.4g, %.4g] of 3 samples, the largest at 0.4, against 0 to 0.5",
                             2. / 3 - 0.4, 0.0, 2. / 3 - 0.4 + e));
  const std::vector<double> a{1, 2, 3, 4}, b{3, 3, 5};
  EXPECT_EQ(two_law_test(a, b, 0.5, 0.05).reason().substr(0, 13), "distance 0.5 ");  // at 2
  EXPECT_EQ(law_samples(0.01, 0.001), static_cast<std::size_t>(std::ceil(2e4 * std::log(2000.))));
}

TEST(LawTest, JumpsOfTheClaimedLawAreNoDistance) {
  random_bits bits(14);
  const auto coin = [](double x) { return x < 0 ? 0.0 : x < 1 ? 0.5 : 1.0; };
  law_test fair(coin, 0.05, 1e-3), biased(coin, 0.05, 1e-3);
  fill(fair, [&] { return uniform(bits) < 0.5 ? 0.0 : 1.0; });
  fill(biased, [&] { return uniform(bits) < 0.35 ? 0.0 : 1.0; });
  EXPECT_TRUE(fair.holds()) << fair.reason();
  EXPECT_EQ(biased.kind(), verdict::refuted) << biased.reason();
}

TEST(LawTest, AVarianceOfOnePerCentMoreIsRefuted) {
  random_bits bits(15);
  std::normal_distribution<double> normal;
  law_test t([](double x) { return std::erfc(-x / std::sqrt(2.)) / 2; }, 0, 1e-3, 5000000);
  fill(t, [&] { return std::sqrt(1.01) * normal(bits); });
  EXPECT_EQ(t.kind(), verdict::refuted) << t.reason();
}

TEST(LawTest, WithAMargin) {
  random_bits bits(16);
  for (int i = 0; i < 5; ++i) {
    law_test healthy(uniform_cdf, 0.02, 1e-4), off(uniform_cdf, 0.02, 1e-4), edge(uniform_cdf, 0.02, 1e-4);
    fill(healthy, [&] { return uniform(bits); });
    fill(off, [&] { return 0.04 + uniform(bits); });
    fill(edge, [&] { return 0.02 + uniform(bits); });
    EXPECT_TRUE(healthy.holds()) << healthy.reason();
    EXPECT_EQ(off.kind(), verdict::refuted) << off.reason();
    EXPECT_EQ(edge.kind(), verdict::inconclusive) << edge.reason();
  }
  std::vector<double> a(two_law_samples(0.1, 1e-4)), b(a.size()), c(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = uniform(bits), b[i] = uniform(bits), c[i] = 0.2 + uniform(bits);
  EXPECT_TRUE(two_law_test(a, b, 0.1, 1e-4).holds()) << two_law_test(a, b, 0.1, 1e-4).reason();
  EXPECT_EQ(two_law_test(a, c, 0.1, 1e-4).kind(), verdict::refuted);
}

TEST(LawTest, BadSamplesAndLaws) {
  EXPECT_EQ(law_test(uniform_cdf, 0.1, 0.01).kind(), verdict::inconclusive);
  EXPECT_EQ(two_law_test({}, {}, 0.1, 0.01).kind(), verdict::inconclusive);
  law_test nan(uniform_cdf, 0.1, 0.01), constant(uniform_cdf, 0.1, 0.01),
      no_law([](double x) { return -x; }, 0.1, 0.01), nowhere([](double) { return NAN; }, 0.1, 0.01);
  nan.add(NAN);
  EXPECT_EQ(nan.reason(), "sample 1 is nan");
  for (auto* t : {&constant, &no_law, &nowhere}) fill(*t, [] { return 0.5; });
  for (const auto* t : {&nan, &constant, &no_law, &nowhere}) EXPECT_EQ(t->kind(), verdict::refuted) << t->reason();
  EXPECT_NE(no_law.reason().find("the claimed law is none"), std::string::npos);
  const std::vector<double> good{1, 2}, bad{1, INFINITY};
  EXPECT_EQ(two_law_test(good, bad, 0.1, 0.01).kind(), verdict::refuted);
  EXPECT_THROW(law_test(uniform_cdf, 0, 0.01), std::invalid_argument);
}

}  // namespace
}  // namespace polhode::testkit_tests
