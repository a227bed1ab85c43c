// SPDX-License-Identifier: Apache-2.0
#include "sphere/lyapunov.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limits>

#include "sphere/closed_forms/gibbs.hpp"
#include "sphere/galerkin/raise_degree.hpp"
#include "sphere/harmonics/wigner.hpp"
#include "sphere/stationary.hpp"

namespace polhode::test {
namespace {

sphere_problem isotropic(double theta, double sigma) {
  return body_on_sphere({1, 2, 3}, theta, 1, sigma * sigma * Eigen::Matrix3d::Identity());
}

/// Root of the mean square over all frames of s = -w.Av + t (x.Ax - v.Av): moments of a frame of degree four.
double mean_stretching(double t, const Eigen::Matrix3d& a) {
  const double square = 3 * (a * a).trace() - a.trace() * a.trace();
  return std::sqrt(square * (1 / 30.0 + 2 * t * t / 15));
}

double corner(const sparse_matrix& a, int degree) {
  return Eigen::MatrixXd(a.block(0, 0, wigner_count(degree), wigner_count(degree))).cwiseAbs().maxCoeff();
}

TEST(Wigner, CoordinatesCommuteLieOnTheSphereAndJoinBothActions) {
  const int degree = 5;
  const auto turn = wigner_generators(degree + 1);
  const auto x = wigner_coordinates(degree + 1, turn);
  sparse_matrix square(x[0].rows(), x[0].cols()), joined = -turn.right[2];
  square.setIdentity();
  square *= -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    square += sparse_matrix(x[i] * x[i]);
    joined += sparse_matrix(x[i] * turn.left[i]);
    EXPECT_LT(corner(sparse_matrix(x[i] * x[j]) - sparse_matrix(x[j] * x[i]), degree), 1e-14);
  }
  EXPECT_LT(corner(square, degree), 1e-14);  // |x| = 1
  EXPECT_LT(corner(joined, degree), 1e-13);  // turning about x from the left is turning about e_3 from the right
}

TEST(Wigner, ActionsHaveTheirBracketsAndCommute) {
  const auto turn = wigner_generators(6);
  const auto bracket = [](const sparse_matrix& a, const sparse_matrix& b) {
    return sparse_matrix(sparse_matrix(a * b) - sparse_matrix(b * a));
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    EXPECT_LT(sparse_matrix(bracket(turn.left[i], turn.left[j]) + turn.left[k]).norm(), 1e-11);
    EXPECT_LT(sparse_matrix(bracket(turn.right[i], turn.right[j]) - turn.right[k]).norm(), 1e-11);
    for (std::size_t n = 0; n < 3; ++n) EXPECT_LT(bracket(turn.left[i], turn.right[n]).norm(), 1e-11);
  }
}

// sqrt(2 l + 1) times the root of the squares of one right index, and the sum over those.
TEST(Wigner, SupremumIsTheSumOverDegreesAndRightIndices) {
  Eigen::VectorXd f = Eigen::VectorXd::Zero(wigner_count(2));
  EXPECT_EQ(frame_supremum(f), 0);
  f[wigner_index(0, 0, 0)] = -0.5;
  EXPECT_DOUBLE_EQ(frame_supremum(f), 0.5);
  f[wigner_index(2, 2, -2)] = 3;
  f[wigner_index(2, -2, -2)] = -4;
  EXPECT_DOUBLE_EQ(frame_supremum(f), 0.5 + std::sqrt(5.0) * 5);
  f[wigner_index(2, 0, 2)] = 2;
  f[wigner_index(1, 1, 0)] = 1;
  EXPECT_DOUBLE_EQ(frame_supremum(f), 0.5 + std::sqrt(5.0) * 7 + std::sqrt(3.0));
}

TEST(Lyapunov, KnownExponents) {
  struct known {
    double theta, sigma, lambda1, within, sum;
  };
  for (const known& k :
       {known{0.5, 0.5, 0.020196, 5e-7, -0.0867830798}, known{0.5, 1, 0.0088201, 5e-8, -0.0235339664},
        known{0.05, 0.3, 0.05635, 5e-6, -0.0026078936}, known{1, 0.5, -0.04358, 5e-6, -0.3056934656}}) {
    const auto found = lyapunov(isotropic(k.theta, k.sigma), 1e-8);
    ASSERT_TRUE(found.reason.empty()) << found.reason;
    EXPECT_NEAR(*found.lambda1, k.lambda1, k.within) << k.theta << ' ' << k.sigma;
    EXPECT_NEAR(found.sum, k.sum, 1e-10);
    const gibbs_law gibbs({1, 2, 3}, 1, 2 * k.theta / (k.sigma * k.sigma));
    EXPECT_NEAR(found.sum, -k.theta * (11 / 6.0 - 6 * gibbs.mean_energy()), 1e-10);
    const double lambda2 = found.sum - *found.lambda1;
    EXPECT_DOUBLE_EQ(found.dimension, *found.lambda1 > 0 ? 1 + *found.lambda1 / std::fabs(lambda2) : 0);
  }
}

// The basis singles out the third axis; the body does not. Noise of any shape, axes relabelled in a cycle, frame turned
// half.
TEST(Lyapunov, DoesNotDependOnTheNamesOfTheAxes) {
  Eigen::Matrix3d q, cycled;
  q << 0.3, 0.1, -0.05, 0.1, 0.2, 0.08, -0.05, 0.08, 0.4;
  for (long i = 0; i < 3; ++i)
    for (long j = 0; j < 3; ++j) cycled((i + 1) % 3, (j + 1) % 3) = q(i, j);
  const auto one = lyapunov(body_on_sphere({1, 2, 3}, 0.4, 1, q), 1e-8),
             other = lyapunov(body_on_sphere({3, 1, 2}, 0.4, 1, cycled), 1e-8);
  ASSERT_TRUE(one.reason.empty() && other.reason.empty()) << one.reason << other.reason;
  EXPECT_NEAR(*one.lambda1, *other.lambda1, 1e-8);
  EXPECT_NEAR(one.sum, other.sum, 1e-9);
}

// Momentum c is momentum 1 with theta c and Q / c, in time scaled by c.
TEST(Lyapunov, ScalesWithTheMomentum) {
  const Eigen::Matrix3d q = Eigen::Vector3d(0.1, 0.3, 0.6).asDiagonal();
  const auto large = lyapunov(body_on_sphere({1, 2, 3}, 0.25, 2, 2 * q), 1e-8),
             unit = lyapunov(body_on_sphere({1, 2, 3}, 0.5, 1, q), 1e-8);
  ASSERT_TRUE(large.lambda1 && unit.lambda1);
  EXPECT_NEAR(*large.lambda1, 2 * *unit.lambda1, 3e-8);
  EXPECT_NEAR(large.sum, 2 * unit.sum, 1e-9);
}

TEST(Lyapunov, ConservesAreaWithoutDissipation) {
  const auto free = lyapunov(isotropic(0, 0.5), 1e-7);
  ASSERT_TRUE(free.lambda1);
  EXPECT_GT(*free.lambda1, 0.01);
  EXPECT_EQ(free.sum, 0);
  EXPECT_EQ(free.dimension, 2);
  const auto rigid =
      lyapunov(body_on_sphere({2, 2, 2}, 0.5, 1, Eigen::Matrix3d::Identity()), 1e-7);  // the flow is a rotation
  ASSERT_TRUE(rigid.lambda1);
  EXPECT_NEAR(*rigid.lambda1, 0, 1e-14);
  EXPECT_EQ(rigid.dimension, 2);
}

TEST(Lyapunov, BarsHoldAtEveryDegree) {
  for (const double theta : {0.0, 0.5}) {
    const auto exact = lyapunov(isotropic(theta, 0.5), 1e-9);
    ASSERT_TRUE(exact.reason.empty()) << exact.reason;
    for (const int degree : {1, 2, 3, 4, 6, 8}) {
      const auto rough = lyapunov(isotropic(theta, 0.5), 1e-9, degree);
      if (!rough.lambda1) continue;
      EXPECT_LE(std::fabs(*rough.lambda1 - *exact.lambda1), rough.uncertainty + exact.uncertainty) << degree;
    }
  }
}

// The body turned, and its noise with it: the flow is the same in another frame.
TEST(Lyapunov, DoesNotDependOnTheFrame) {
  const Eigen::Matrix3d a = Eigen::Vector3d(1, 0.5, 1 / 3.0).asDiagonal(), q = Eigen::Vector3d(1, 0.7, 2).asDiagonal();
  const auto turned = [&](const Eigen::Matrix3d& r) {
    return lyapunov({r * a * r.transpose(), 0.4, 1, r * q * r.transpose()}, 1e-8);
  };
  const auto straight = turned(Eigen::Matrix3d::Identity());
  for (const Eigen::Vector3d& axis : {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(1, 2, -2)}) {
    const auto other = turned(Eigen::AngleAxisd(0.7, axis.normalized()).toRotationMatrix());
    ASSERT_TRUE(other.lambda1) << other.reason;
    EXPECT_NEAR(*other.lambda1, *straight.lambda1, 2e-8) << axis;
    EXPECT_NEAR(other.sum, straight.sum, 1e-9) << axis;
  }
}

// Noise along (1, 1, 1): of its covariance all entries beside the diagonal are one.
TEST(Lyapunov, OfNoiseAlongTheDiagonalIsThatAlongAnAxis) {
  const Eigen::Matrix3d r = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), Eigen::Vector3d::Ones())
                                .toRotationMatrix(),
                        a = Eigen::Vector3d(1, 0.5, 1 / 3.0).asDiagonal(), one = Eigen::Matrix3d::Identity();
  const auto diagonal = lyapunov({a, 0.4, 1, one + Eigen::Matrix3d::Ones()}, 1e-8);
  const auto along_an_axis = lyapunov({r.transpose() * a * r, 0.4, 1, Eigen::Vector3d(1, 1, 4).asDiagonal()}, 1e-8);
  ASSERT_TRUE(diagonal.lambda1 && along_an_axis.lambda1);
  EXPECT_NEAR(*diagonal.lambda1, *along_an_axis.lambda1, 2e-8);
}

// A thousand million times slower, noise as well.
TEST(Lyapunov, OfASlowFlowIsAsManyTimesLess) {
  const double slow = 1e-9;
  const auto p = isotropic(0.5, 1);
  const auto one = lyapunov(p, 1e-8), other = lyapunov({slow * p.quadratic, 0.5, 1, slow * p.covariance}, 1e-8 * slow);
  ASSERT_TRUE(one.lambda1 && other.lambda1) << other.reason;
  EXPECT_NEAR(*other.lambda1 / slow, *one.lambda1, 2e-8);
}

// Of a rotation degree four is enough; what stretches takes three degrees to tell.
TEST(Lyapunov, KeepsNothingOfAnotherBody) {
  const auto rigid = lyapunov(body_on_sphere({2, 2, 2}, 0.5, 1, 4 * Eigen::Matrix3d::Identity()), 1e-6);
  const auto other = lyapunov(isotropic(0.5, 2), 1e-6);
  EXPECT_EQ(rigid.degree, 4);
  EXPECT_EQ(other.degree, 8);
  EXPECT_NEAR(*other.lambda1, *lyapunov(isotropic(0.5, 2), 1e-12).lambda1, 1e-12);
}

// Its frames fall into blocks by the turns about the axis, and one of them is affordable where all together are not:
// nothing that cancels may tie them.
TEST(Lyapunov, OfABodyOfRevolutionIsAffordableToAHighDegree) {
  const double sum = 0.1 + 0.2;  // is not 0.3: noise that is the same in both directions but for rounding
  auto top = body_on_sphere({1, 1, 2.5}, 0.5, 1, Eigen::Vector3d(0.3, sum, 0.4).asDiagonal());
  top.field = {0, 0, 0.3};
  const auto high = lyapunov(top, 1e-9, 28);
  ASSERT_TRUE(high.lambda1) << high.reason;
  EXPECT_EQ(high.degree, 28);
  EXPECT_NEAR(*high.lambda1, *lyapunov(top, 1e-11).lambda1, 1e-11);
}

TEST(Lyapunov, TheAttractorIsAPointOrTheSphereAtTheLimits) {
  EXPECT_EQ(kaplan_yorke(0, -0.5), 0);
  EXPECT_EQ(kaplan_yorke(-0.1, -0.5), 0);
  EXPECT_DOUBLE_EQ(kaplan_yorke(0.1, -0.5), 1 + 1 / 6.0);
  EXPECT_EQ(kaplan_yorke(0.1, -0.9e-13), 2);
  EXPECT_DOUBLE_EQ(kaplan_yorke(1e-13, -1e-13), 1.5);  // from here on area is lost
}

// It is three degrees that tell, by their changes over the mean stretching, even where the first would do.
TEST(Lyapunov, IsAsUncertainAsThreeDegreesTell) {
  for (const double sigma : {1.0, 1.4}) {
    const auto p = isotropic(0.5, sigma);
    const auto found = lyapunov(p, 1e-3);
    ASSERT_TRUE(found.reason.empty()) << found.reason;
    EXPECT_EQ(found.degree, 8);
    const auto at = [&](int degree) { return *lyapunov(p, 1e-3, degree).lambda1; };
    three_agree agreement;
    const double size = mean_stretching(0.5, p.quadratic), first = at(4), second = at(6);
    agreement.uncertainty(unbounded, size);
    agreement.uncertainty(std::fabs(second - first), size);
    const double told = agreement.uncertainty(std::fabs(at(8) - second), size);
    EXPECT_NEAR(found.uncertainty, told, 1e-3 * told) << sigma;
  }
}

TEST(Lyapunov, IsNeverMoreCertainThanRounding) {
  const auto p = isotropic(0.5, 3);
  const auto found = lyapunov(p, 1e-9);
  ASSERT_TRUE(found.reason.empty()) << found.reason;
  EXPECT_NEAR(found.uncertainty, 1e-14 * mean_stretching(0.5, p.quadratic), 1e-20);
}

// Of a rotation nothing stretches at any degree.
TEST(Lyapunov, OfARotationConvergesToAnyTolerance) {
  const auto rigid = lyapunov(body_on_sphere({2, 2, 2}, 0, 1, Eigen::Matrix3d::Identity()), 0);
  EXPECT_EQ(rigid.reason, "");
  EXPECT_EQ(rigid.lambda1, 0);
  EXPECT_EQ(rigid.sum_uncertainty, 0);
}

// Degree one has no stretching, and zero is what it answers: the first of three for a wanted degree of four.
TEST(Lyapunov, OfALowDegreeHasABar) {
  const auto p = isotropic(0.5, 2);
  const auto exact = lyapunov(p, 1e-10), one = lyapunov(p, 1e-8, 1), two = lyapunov(p, 1e-8, 2),
             four = lyapunov(p, 1e-8, 4);
  EXPECT_FALSE(one.lambda1);
  ASSERT_TRUE(two.lambda1 && four.lambda1);
  EXPECT_GT(two.uncertainty, std::fabs(*two.lambda1 - *exact.lambda1));
  EXPECT_LT(two.uncertainty, 0.1);
  const double size = mean_stretching(0.5, p.quadratic);
  EXPECT_NEAR(four.uncertainty, size * std::pow(*two.lambda1 / size, 1.5), 1e-9 * size);
}

// The sum is six times the dissipation a mean on the sphere, which is asked for sixty times as finely over that.
TEST(Lyapunov, TheSumIsAsUncertainAsTheMeanOnTheSphere) {
  const double theta = 10, tolerance = 1e-4;
  const auto p = isotropic(theta, 3);
  const auto found = lyapunov(p, tolerance);
  EXPECT_EQ(found.reason, "");
  const auto mean = stationary_mean(
      p, [&](const Eigen::Vector3d& pi) { return p.energy(pi); }, tolerance / (60 * theta));
  const double written_otherwise = 1e-12;  // rounding of the energy, here not as in the source
  EXPECT_NEAR(found.sum_uncertainty, 6 * theta * mean.uncertainty, written_otherwise * found.sum_uncertainty);
  EXPECT_LE(found.sum_uncertainty, tolerance / 10);
  EXPECT_GT(found.sum_uncertainty, 0);
}

// Where degrees that agree would say nothing there is a proved bar.
TEST(Lyapunov, OfFaintNoiseHasAProvedBar) {
  const auto faint = lyapunov(isotropic(0, 1e-3), 1e-7);
  EXPECT_NE(faint.reason, "");
  ASSERT_TRUE(faint.lambda1);
  EXPECT_GT(faint.uncertainty, 1e-3);
}

// About 5.8e-4 by simulation; degrees that resolve nothing agree on zero.
TEST(Lyapunov, FaintNoiseIsRefusedWithTheDegreeItWouldTake) {
  const auto faint = lyapunov(isotropic(0, 1e-4), 1e-7);
  EXPECT_NE(faint.reason.find("about 82000 would be needed"), std::string::npos) << faint.reason;
  EXPECT_TRUE(!faint.lambda1 || faint.uncertainty > 1e-3);
}

TEST(Lyapunov, SaysWhatItCannotGive) {
  EXPECT_NE(lyapunov(isotropic(0.5, 0), 1e-6).reason.find("no noise"), std::string::npos);
  const auto faint = lyapunov(isotropic(0.5, 0.05), 1e-9);
  EXPECT_NE(faint.reason.find("not converged"), std::string::npos) << faint.uncertainty;
}

}  // namespace
}  // namespace polhode::test
