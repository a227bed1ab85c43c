// SPDX-License-Identifier: Apache-2.0
// Expectations by the generator on the sphere: known answers, another projection, and bars that hold at every degree.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "sphere/expectations/deterministic.hpp"
#include "sphere/galerkin/raise_degree.hpp"
#include "sphere/harmonics/backward_operator.hpp"
#include "sphere/harmonics/harmonics.hpp"
#include "sphere/spectral_gap.hpp"
#include "sphere/stationary.hpp"
#include "support/dense.hpp"
#include "unit/sphere/problems.hpp"

namespace polhode::test {
namespace {

TEST(Expectation, ScenePaper) {
  const std::vector<std::pair<std::string_view, double>> known{{"energy", 0.281221439758},
                                                               {"pi1", 0.22605229629},
                                                               {"pi2", 0.44478743232},
                                                               {"pi3", 0.32280817976},
                                                               {"exp(pi3)", 1.55190822842}};
  for (const auto& [name, value] : known) holds(expectation(paper(), observable(name), start, 2, 1e-10), value, 1e-11);
  holds(expectation(paper(), observable("casimir"), start, 2, 1e-12), 0.5, 1e-13);
}

TEST(Expectation, EqualInertiasDecayAndTimeZero) {
  const auto round = body_on_sphere({2, 2, 2}, 0, 1, 0.25 * Eigen::Matrix3d::Identity());
  for (const double t : {0.0, 0.7, 30.0})
    for (int k = 0; k < 3; ++k)
      holds(expectation(
                round, [k](const Eigen::Vector3d& pi) { return pi[k]; }, start, t, 1e-12),
            std::exp(-0.25 * t) * start[k], 1e-13);
}

// Momentum c, time T is momentum 1, time cT with theta c and Q / c.
TEST(Expectation, ScalesWithTheMomentum) {
  sphere_problem large = problem(0.25, 0.5 * oblique());
  large.radius = 2;
  const sphere_problem unit = problem(0.5, 0.25 * oblique());
  const auto f = observable("exp(pi3)");
  const auto scaled = [&](const Eigen::Vector3d& pi) { return f(2 * pi); };
  const auto expected = expectation(unit, scaled, start, 3, 1e-11);
  holds(expectation(large, f, 2 * start, 1.5, 1e-10), *expected.value, 2e-10);
}

// The same projection written down another way: products by quadrature, the matrix exponential in full. Noise of any
// shape.
TEST(Expectation, AgreesWithTheDenseExponential) {
  const int degree = 20;
  const auto p = problem(0.8, oblique());
  const auto rule = sphere_quadrature(2 * degree + 2);
  const Eigen::MatrixXd y = harmonics(rule.points, degree), weighted = rule.weights.asDiagonal() * y;
  const auto turn = rotation_generators(degree);
  Eigen::MatrixXd generator = Eigen::MatrixXd::Zero(y.cols(), y.cols());
  for (long i = 0; i < 3; ++i) {
    Eigen::VectorXd a(y.rows());
    for (long n = 0; n < y.rows(); ++n) {
      const Eigen::Vector3d x = rule.points.row(n), rate = x.array() / Eigen::Array3d(1, 2, 3);
      a[n] = (rate + p.damping * x.cross(rate))[i];
    }
    generator -= weighted.transpose() * a.asDiagonal() * y * turn[i];
    for (long j = 0; j < 3; ++j) generator += 0.5 * p.covariance(i, j) * Eigen::MatrixXd(turn[i] * turn[j]);
  }
  EXPECT_LT((generator - Eigen::MatrixXd(backward_operator(p, degree))).cwiseAbs().maxCoeff(), 1e-11);
  const Eigen::MatrixXd propagator = test::exponential_of(1.5 * generator);
  for (const auto name : {"energy", "pi1", "pi2^2"}) {
    const auto f = observable(name);
    const double dense = harmonics_at(start, degree).dot(propagator * harmonic_coefficients(f, degree));
    holds(expectation(p, f, start, 1.5, 1e-10), dense, 1e-9);
  }
}

TEST(Expectation, SaysWhatItCannotGive) {
  const auto still = expectation(problem(0.5, Eigen::Matrix3d::Zero()), observable("energy"), start, 1e300, 1e-9);
  EXPECT_FALSE(still.value);
  EXPECT_NE(still.reason.find("no noise"), std::string::npos);
  const auto faint = problem(0.5, 1e-6 * Eigen::Matrix3d::Identity());
  const auto hard = expectation(faint, observable("pi1"), start, 5000, 1e-9);
  EXPECT_FALSE(hard.converged());
  EXPECT_TRUE(!hard.value || hard.uncertainty > 1e-9);
  const auto hopeless = expectation(faint, observable("pi1"), start, 1e9, 1e-9);
  EXPECT_FALSE(hopeless.value);
  EXPECT_FALSE(hopeless.reason.empty());
}

// The bar is proved, so it holds at a degree that resolves little too.
TEST(Expectation, BarsHoldAtEveryDegree) {
  for (const double sigma : {0.1, 0.5})
    for (const double time : {0.3, 2.0, 20.0}) {
      const auto p = problem(0.5, sigma * sigma * Eigen::Matrix3d::Identity());
      for (const auto name : {"energy", "pi2", "exp(pi3)"}) {
        const auto exact = expectation(p, observable(name), start, time, 1e-10);
        ASSERT_TRUE(exact.converged()) << exact.reason;
        for (const int degree : {1, 2, 4, 6, 8, 12, 16}) {
          const auto rough = expectation(p, observable(name), start, time, 1e-10, degree);
          ASSERT_TRUE(rough.value);
          EXPECT_LE(std::fabs(*rough.value - *exact.value), rough.uncertainty + exact.uncertainty) << name << degree;
        }
      }
    }
}

// Where three degrees tell more than the proof, by their changes over the size of the observable.
TEST(Expectation, IsAsUncertainAsThreeDegreesTell) {
  const auto f = observable("pi3");
  const double time = 8;
  const auto found = expectation(paper(), f, start, time, 5e-9);
  ASSERT_TRUE(found.converged()) << found.reason;
  three_agree agreement;
  double before = std::numeric_limits<double>::quiet_NaN(), told = 0, proved = 0;
  for (const int degree : {8, 12, 16, 24, 32}) {
    if (degree > found.degree) break;
    const auto at = expectation(paper(), f, start, time, 1e-13, degree);
    const double change = std::fabs(*at.value - before);
    told = agreement.uncertainty(std::isnan(change) ? unbounded : change, std::sqrt(1.0 / 3));
    proved = at.uncertainty;
    before = *at.value;
  }
  EXPECT_LT(told, proved / 2);
  EXPECT_NEAR(found.uncertainty, told, 1e-6 * told);
}

// Of so faint noise agreement says nothing; degrees are raised until the proof does.
TEST(Expectation, UnderFaintNoiseIsProved) {
  const auto faint = problem(0.5, 1e-14 * Eigen::Matrix3d::Identity());
  const auto f = observable("pi3");
  const auto found = expectation(faint, f, start, 1.6, 1e-9);
  EXPECT_GT(found.degree, 24);
  holds(found, *on_the_path(problem(0.5, Eigen::Matrix3d::Zero()), f, start, 1.6).value, 1e-9);
}

TEST(Expectation, TakesAnyWantedDegree) {
  const auto round = body_on_sphere({2, 2, 2}, 0, 1, 0.25 * Eigen::Matrix3d::Identity());
  for (const int degree : {1, 2, 7}) {
    const auto found = expectation(round, observable("pi2"), start, 0.7, 1e-12, degree);
    EXPECT_EQ(found.degree, degree);
    holds(found, std::exp(-0.175) * start[1], 1e-13);
  }
}

// Free motion keeps the figure component, L Pi_2 = -(Q_11 + Q_33) / 2 Pi_2; noise is 1e-15 of the rotation.
TEST(Expectation, SeesWeakNoiseNextToFastRotation) {
  const Eigen::Vector3d noise(3.7e-10, 3.7e-10, 1.1e-10);
  const auto p = body_on_sphere({0.002, 0.6, 0.002}, 0, 160, noise.asDiagonal());
  const double time = 6000, expected = 160 * start[1] * std::exp(-(noise[0] + noise[2]) / 2 * time);
  for (const int degree : {8, 20, 32}) {
    const auto found = expectation(p, observable("pi2"), 160 * start, time, 1e-11, degree);
    ASSERT_TRUE(found.value) << found.reason;
    EXPECT_LE(found.uncertainty, 1e-9);
    EXPECT_NEAR(*found.value, expected, found.uncertainty) << degree;
  }
}

// A wanted degree has its proved bar alone, which grows with time, until 60 relaxations of the slowest have passed.
TEST(Expectation, IsTheStationaryMeanLongAfter) {
  const auto p = problem(0.4, Eigen::Vector3d(1, 0.7, 1.3).asDiagonal());
  const auto gap = spectral_gap(p, std::numeric_limits<double>::infinity());
  ASSERT_TRUE(gap.converged());
  const double long_ago = 60 / (*gap.value - gap.uncertainty);
  const auto f = observable("pi1^2");
  const auto late = stationary_mean(p, f, 1e-10, 12);
  ASSERT_TRUE(late.converged()) << late.reason;
  for (const double share : {0.999, 1.001}) {
    const auto found = expectation(p, f, start, share * long_ago, 1e-10, 12);
    EXPECT_EQ(found.converged(), share > 1) << found.uncertainty;
    EXPECT_EQ(found.forgotten, share > 1);
    EXPECT_NEAR(*found.value, *late.value, 1e-10);
  }
}

}  // namespace
}  // namespace polhode::test
