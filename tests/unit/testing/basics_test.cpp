// SPDX-License-Identifier: Apache-2.0
// Budget, deviates, verdicts.
#include <polhode/testing/alarm_budget.hpp>
#include <polhode/testing/moments.hpp>
#include <polhode/testing/quantiles.hpp>

#include "kit.hpp"

namespace polhode::testkit_tests {
namespace {

using namespace testkit;

TEST(Kit, ABudgetIsNeverOverspent) {
  alarm_budget any(1e-3), equal(1e-3, 20);
  double sum = 0, rest = 0;
  for (int k = 1; k <= 100000; ++k) sum += any.share(k);
  rest = 1e-3 * 6 / (M_PI * M_PI) / 100000.5;  // sum of 1/k^2 beyond, to O(k^-3)
  EXPECT_NEAR(sum + rest, 1e-3, 1e-16);
  EXPECT_DOUBLE_EQ(any.next(), any.share(1));
  EXPECT_DOUBLE_EQ(any.next(), any.share(2));
  for (int k = 1; k <= 20; ++k) EXPECT_DOUBLE_EQ(equal.next(), 5e-5);
  EXPECT_THROW(equal.next(), std::out_of_range);
  EXPECT_EQ(equal.given(), 20);
  EXPECT_THROW(any.share(0), std::out_of_range);
  EXPECT_THROW(alarm_budget(0), std::invalid_argument);
  EXPECT_THROW(alarm_budget(1), std::invalid_argument);
  EXPECT_THROW(alarm_budget(NAN), std::invalid_argument);
}

TEST(Kit, DeviatesAreThoseOfBoost) {
  for (double tail : {0.9, 0.5, 0.4, 0.025, 1e-4, 1e-9, 1e-15, 1e-200})
    EXPECT_NEAR(testkit::normal_deviate(tail), polhode::normal_deviate(tail), 2e-14 * 40);
  for (double degrees : {1., 2., 3., 7.5, 31., 127., 1023., 1048575.})
    for (double tail : {0.45, 0.1, 0.025, 1e-4, 1e-8, 1e-12}) {
      const double t = student_deviate(tail, degrees);
      EXPECT_NEAR(polhode::student_t_tail(t, degrees) / tail, 1, 1e-8) << tail << ' ' << degrees;
      EXPECT_NEAR(t / -student_t_quantile(tail, degrees), 1, 1e-8) << tail << ' ' << degrees;
    }
}

TEST(Kit, VerdictsComeFromIntervals) {
  EXPECT_EQ(judge({0.95, 1.05}, 1, 0.1), verdict::holds);
  EXPECT_EQ(judge({0.8, 1.05}, 1, 0.1), verdict::inconclusive);
  EXPECT_EQ(judge({1.11, 1.2}, 1, 0.1), verdict::refuted);
  EXPECT_EQ(judge({0.9, 1.1}, 1, 0), verdict::inconclusive);
  EXPECT_EQ(judge({NAN, 1}, 1, 0.1), verdict::inconclusive);
  EXPECT_EQ(judge({-INFINITY, INFINITY}, 1, 0.1), verdict::inconclusive);
  EXPECT_STREQ(to_string(verdict::inconclusive), "inconclusive");
}

TEST(Kit, MomentsOfASmallSampleByHand) {
  moments m;
  for (double x : {1., 2., 3., 10.}) m.add(x + 1e6);
  EXPECT_NEAR(m.mean(), 1e6 + 4, 1e-9);
  EXPECT_NEAR(m.variance(), 50. / 3, 1e-8);                   // 9 + 4 + 1 + 36
  EXPECT_NEAR(m.skewness(), 45 / std::pow(12.5, 1.5), 1e-8);  // (-27 - 8 - 1 + 216) / 4
  EXPECT_NEAR(m.standard_error(), std::sqrt(50. / 12), 1e-9);
}

}  // namespace
}  // namespace polhode::testkit_tests
