// SPDX-License-Identifier: Apache-2.0
// The second methods of the attack on the references: against known answers and each other; the averaged gap.
#include "support/second_opinions.hpp"

#include <gtest/gtest.h>

#include "sphere/averaged_gap.hpp"
#include "sphere/expectations/expectation.hpp"
#include "sphere/harmonics/backward_operator.hpp"
#include "sphere/lyapunov.hpp"
#include "sphere/spectral_gap.hpp"
#include "sphere/stationary.hpp"
#include "support/body_of_revolution.hpp"
#include "support/power_series_in_time.hpp"
#include "support/sphere_collocation.hpp"
#include "unit/sphere/problems.hpp"

namespace polhode::test {
namespace {

sphere_function energy_of(const sphere_problem& p) { return *named_observable("energy", p); }
const std::vector<sphere_problem> tops{
    body_on_sphere({1, 1, 2.5}, 0, 1.3, Eigen::Vector3d(0.25, 0.25, 0.4).asDiagonal()),
    body_on_sphere({1, 0.4, 1}, 0.5, 1.3, 0.25 * one), body_on_sphere({1.7, 2, 2}, 0.5, 1.3, 0.25 * one)};

TEST(SphereCollocation, KnownAnswers) {  // docs/model.md, section 3
  const sphere_collocation grid(13, drift_of(paper()), paper().covariance);
  EXPECT_NEAR(grid.mean(energy_of(paper())), 0.27662786228, 2e-9);
  EXPECT_NEAR(sphere_collocation(11, drift_of(paper()), paper().covariance).expectation(energy_of(paper()), start, 2),
              0.281221439758, 1e-8);
  EXPECT_NEAR(grid.gap(), 0.237066066867, 5e-8);
}

TEST(SphereCollocation, SaysWhereItHasLostItsDigitsOrResolvesNothing) {
  const auto next_to_rounding = body_on_sphere(
      {2.6, 0.35, 0.41}, 0.02, 0.0012, 1e9 * Eigen::Vector3d(2, -2.3, -1.3) * Eigen::RowVector3d(2, -2.3, -1.3));
  opinions all;
  add_collocated_mean(all, next_to_rounding, energy_of(next_to_rounding), 1e-6);
  EXPECT_TRUE(all.empty() || all[0].uncertainty > 1e-9);
  // The grid holds an equilibrium of greatest energy; the law is at the least.
  const auto no_noise = body_on_sphere({0.55, 0.61, 0.61}, 100, 1, Eigen::Vector3d(6, 3, 6).asDiagonal() * 1e-13);
  const double least = 1 / (2 * 0.61);
  all.clear();
  add_collocated_mean(all, no_noise, energy_of(no_noise), least);
  for (const auto& second : all) EXPECT_LE(std::fabs(second.value - least), second.uncertainty);
}

TEST(BodyOfRevolution, AgreesWithTheReferences) {
  for (const auto& p : tops) {
    const auto body = revolution(p);
    ASSERT_TRUE(body);
    const auto expected = expectation(p, energy_of(p), p.radius * start, 2, 1e-11);
    EXPECT_NEAR(energy_on_a_line(*body, start[body->axis], 2, 48), *expected.value, expected.uncertainty + 1e-12);
    const auto gap = spectral_gap(p, 1e-11);
    EXPECT_NEAR(gap_on_a_line(*body, 48, 4), *gap.value, gap.uncertainty + 1e-11);
  }
  EXPECT_FALSE(revolution(paper()));
}

TEST(BodyOfRevolution, TangentDirectionsAreADiffusionOnASphere) {
  const auto& p = tops[0];
  const auto exponents = lyapunov(p, 1e-7);
  ASSERT_TRUE(exponents.lambda1);
  EXPECT_NEAR(lambda1_on_the_sphere(*revolution(p), 15), *exponents.lambda1, exponents.uncertainty + 1e-9);
}

TEST(SeriesInTime, AgreesWithTheExponential) {
  Eigen::Matrix<double, 2, 3> two;
  two << 0.9, 0.2, 0, -0.1, 0.8, 0.5;
  for (const auto& [theta, time] : {std::pair{0.0, 0.05}, {0.5, 0.02}}) {
    const auto p = body_on_sphere({1, 2, 3}, theta, 1, two.transpose() * two);
    const auto series = energy_by_series(p, start, time, 1e-13);
    ASSERT_TRUE(series);
    const auto expected = expectation(p, energy_of(p), start, time, 1e-12);
    EXPECT_NEAR(series->value, *expected.value, series->remainder + expected.uncertainty);
    EXPECT_GT(std::fabs(series->value - energy_of(p)(start)), 1e-4);  // something has happened
  }
}

// One dimension is exact for the modes about which a body of revolution turns.
TEST(AveragedGap, IsThatOfABodyOfRevolution) {
  for (sphere_problem p : tops) {
    p.covariance = 0.25 * one;
    const auto averaged = averaged_gap(p);
    ASSERT_TRUE(averaged);
    EXPECT_NEAR(averaged->gap(), gap_on_a_line(*revolution(p), 40, 0), 1e-8);
  }
}

// h itself is an even mode, of rate 3 sigma^2; the exact gaps rise to the limit, short of it by about sigma.
TEST(AveragedGap, IsTheLimitOfExactGapsAsTheNoiseFades) {
  const auto averaged = averaged_gap(body_on_sphere({1, 2, 3}, 0, 1, one));
  ASSERT_TRUE(averaged);
  EXPECT_NEAR(averaged->even, 3, 1e-6);
  EXPECT_NEAR(averaged->gap(), 1.884, 5e-4);
  double last = 0;
  for (const double sigma : {0.4, 0.2}) {
    const auto exact = spectral_gap(body_on_sphere({1, 2, 3}, 0, 1, sigma * sigma * one), 1e-9);
    ASSERT_TRUE(exact.converged());
    const double missing = averaged->gap() - *exact.value / (sigma * sigma);
    EXPECT_GT(missing, 0);
    if (last > 0) {
      EXPECT_NEAR(last / missing, 1.6, 0.4);
    }
    last = missing;
  }
}

TEST(AveragedGap, IsNamedWhereTheGapIsRefused) {
  const auto refused = spectral_gap(body_on_sphere({1, 2, 3}, 0, 1, 2.5e-5 * one), 1e-9);
  EXPECT_FALSE(refused.converged());
  EXPECT_NE(refused.reason.find("is 4.71e-05 at this strength"), std::string::npos) << refused.reason;
  EXPECT_FALSE(averaged_gap(body_on_sphere({2, 2, 2}, 0, 1, one)));
  EXPECT_FALSE(averaged_gap(body_on_sphere({1, 2, 3}, 0.5, 1, Eigen::Vector3d(1, 2, 3).asDiagonal())));
}

// Noise about one axis only, on a body next to spherical: degrees agreed on what converges as a power of the degree.
TEST(StationaryMean, SlowConvergenceIsNotTakenForConvergence) {
  auto p = body_on_sphere({3.0377824024688329, 3.0377824005045042, 3.0377824009503032}, 0.016481350527746543,
                          1.7905436987210701, Eigen::Matrix3d::Zero());
  const Eigen::Vector3d sigma(0.013594, 0.208435, -0.072977);
  p.covariance = sigma * sigma.transpose();
  const double truth = *stationary_mean(p, energy_of(p), 1e-13, 48).value;
  int answered = 0;
  for (const int degree : {0, 12, 16}) {
    const auto found = stationary_mean(p, energy_of(p), 5e-12, degree);
    if (!found.value) continue;
    ++answered;
    EXPECT_LE(std::fabs(*found.value - truth), found.uncertainty) << degree;
  }
  EXPECT_GT(answered, 0);
  EXPECT_GT(needed_degree(p), 1000);
}

}  // namespace
}  // namespace polhode::test
