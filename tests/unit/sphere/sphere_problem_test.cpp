// SPDX-License-Identifier: Apache-2.0
// Any h of degree two on the sphere: fields, products of components, noise that depends on the state.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "sphere/expectations/expectation.hpp"
#include "sphere/harmonics/backward_operator.hpp"
#include "sphere/lyapunov.hpp"
#include "sphere/spectral_gap.hpp"
#include "sphere/stationary.hpp"
#include "sphere/uniqueness.hpp"
#include "unit/sphere/problems.hpp"

namespace polhode::test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

sphere_problem spin() {
  Matrix3d quadratic;
  quadratic << 1, 0.3, -0.2, 0.3, -0.5, 0.1, -0.2, 0.1, 0.2;
  Matrix3d root;
  root << 0.5, 0.1, 0, 0.2, 0.6, 0.1, 0, -0.2, 0.4;
  return {quadratic, 0.4, 1.3, root * root.transpose(), {0.3, -0.2, 0.5}};
}

sphere_problem turned(const sphere_problem& p, const Matrix3d& r) {
  return {r * p.quadratic * r.transpose(), p.damping, p.radius, r * p.covariance * r.transpose(), r * p.field};
}

// Eigenvalues 4, -2 and 1, of which the diagonal shows one: reached by h and Omega where no field is, bounds elsewhere.
TEST(SphereProblem, SpreadAndBoundsAreThoseOfItsEigenvalues) {
  Matrix3d quadratic;
  quadratic << 1, 3, 0, 3, 1, 0, 0, 0, 1;
  for (const auto& p :
       {sphere_problem{quadratic, 0.4, 1.5, one}, sphere_problem{quadratic, 0.4, 1.5, one, {2, 2, 1}}}) {
    const double field = p.field.norm();
    EXPECT_NEAR(p.spread(), 6, 1e-14);
    EXPECT_NEAR(greatest_energy_on(p), 1.5 * (1.5 * 4 / 2 + field), 1e-13);
    EXPECT_NEAR(greatest_rate_on(p), 1.5 * 4 + field, 1e-13);
  }
  EXPECT_EQ((sphere_problem{Vector3d(-3, 1, 2).asDiagonal(), 0, 1, one}.spread()), 5);
  EXPECT_EQ((greatest_rate_on({Vector3d(-3, 1, 2).asDiagonal(), 0, 2, one})), 6);
}

TEST(SphereProblem, SpreadOfAMatrixThatIsNextToDiagonal) {
  Matrix3d quadratic;
  quadratic << 2, 1, 0, 1, 2, 0, 0, 0, 1.5;  // eigenvalues 3, 1 and 1.5
  EXPECT_NEAR((sphere_problem{quadratic, 0, 1, one}.spread()), 2, 1e-14);
  quadratic << 1, 1e-9, 0, 1e-9, 1, 0, 0, 0, 1;
  EXPECT_NEAR((sphere_problem{quadratic, 0, 1, one}.spread()), 2e-9, 1e-15);
}

TEST(NamedObservables, AreWhatTheirMeaningsSay) {
  Matrix3d quadratic;
  quadratic << 1, 0.3, -0.2, 0.3, -0.5, 0.1, -0.2, 0.1, 0.2;
  const sphere_problem p{quadratic, 0.4, 1.3, one, {0.3, -0.2, 0.5}};
  const Vector3d pi(0.7, -1.1, 0.4);
  const auto at = [&](const char* name) { return (*named_observable(name, p))(pi); };
  const double squares = (1 * 0.49 - 0.5 * 1.21 + 0.2 * 0.16) / 2;
  const double products = 0.3 * 0.7 * -1.1 - 0.2 * 0.7 * 0.4 + 0.1 * -1.1 * 0.4;
  EXPECT_NEAR(at("energy"), squares + products + 0.3 * 0.7 + 0.2 * 1.1 + 0.5 * 0.4, 1e-15);
  EXPECT_NEAR(at("casimir"), (0.49 + 1.21 + 0.16) / 2, 1e-15);
  EXPECT_NEAR(at("exp(pi3)"), std::exp(0.4), 1e-15);
  EXPECT_EQ(at("pi2"), -1.1);
  EXPECT_EQ(at("mu_1"), 0.7);
  EXPECT_NEAR(at("pi1^2"), 0.49, 1e-15);
  EXPECT_FALSE(named_observable("pi4", p));
}

TEST(SphereProblem, NoiseGrowsByAShareOfItselfAndItsCovarianceByTheSquare) {
  auto p = spin();
  p.varying = {{Vector3d(0.1, 0.2, 0.3), 2 * one}};
  const auto more = with_more_noise(p, 0.5);
  EXPECT_TRUE(more.covariance.isApprox(2.25 * p.covariance));
  EXPECT_TRUE(more.varying[0].constant.isApprox(1.5 * p.varying[0].constant));
  EXPECT_TRUE(more.varying[0].slope.isApprox(3 * one));
  EXPECT_EQ(more.damping, p.damping);
  EXPECT_DOUBLE_EQ(with_more_dissipation(p, 0.5).damping, 0.6);
}

// Of a field that depends on the state the greatest on the sphere, squared.
TEST(NoiseRate, IsTheTraceAndTheSquareOfWhatVaries) {
  auto p = spin();
  p.radius = 2;
  const double trace = p.covariance.trace();
  EXPECT_DOUBLE_EQ(noise_rate(p), trace);
  p.varying = {{Vector3d(0, 0.3, 0.4), 0.1 * one}};
  EXPECT_NEAR(noise_rate(p), trace + std::pow(0.5 + 2 * 0.1 * std::sqrt(3.0), 2), 1e-14);
}

// Its rule, written out: the shear of turning and damping over the noise, or what damping draws out over the noise
// across the noise's own axis. Spreads 4, of |Pi| = 2: turning 8.
TEST(NeededDegree, IsTenOverTheWidthOfTheNoise) {
  const auto needed = [](double damping, const Vector3d& noise, const Vector3d& field = Vector3d::Zero()) {
    return needed_degree({Vector3d(1, 5, 3).asDiagonal(), damping, 2, noise.asDiagonal(), field});
  };
  const Vector3d all(0.1, 0.2, 0.3), axis(0, 0, 0.5);
  EXPECT_NEAR(needed(0, all), 10 * std::sqrt(3 * 8 / 0.6), 1e-12);
  const double damping = 0.25 * 2 * (8 + 0.5), shear = std::hypot(8, damping);
  EXPECT_NEAR(needed(0.25, all, {0.3, 0, 0.4}), 10 * std::sqrt(3 * shear / 0.6), 1e-12);
  const double fast = 4 * 2 * 8.0, sheared = std::hypot(8, fast);  // damping that draws out more than noise crosses
  EXPECT_NEAR(needed(4, {30, 40, 50}),
              10 * std::sqrt(3 * std::max(sheared / 120, fast / (70 + sheared * sheared / 120))), 1e-12);
  EXPECT_GT(fast / (70 + sheared * sheared / 120), sheared / 120);
  const double faint = 0.01 * 2 * 8;  // noise about one axis: turning crosses it
  EXPECT_NEAR(needed(0.01, axis),
              10 * std::sqrt(3 * std::max(std::hypot(8, faint) / 0.5, faint / (64 + faint * faint) * 0.5)), 1e-12);
  EXPECT_EQ(needed(0.25, Vector3d::Zero()), HUGE_VAL);
}

TEST(SphereProblem, NoAxesArePreferred) {
  const Matrix3d r = Eigen::AngleAxisd(0.8, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  const auto p = spin(), other = turned(p, r);
  const Vector3d from = p.radius * start;
  const auto f = [](const Vector3d& pi) { return std::exp(pi[2]) + pi[0] * pi[1]; };
  const auto turned_f = [&](const Vector3d& pi) { return f(r.transpose() * pi); };
  EXPECT_NEAR(*expectation(p, f, from, 0.9, 1e-9).value, *expectation(other, turned_f, r * from, 0.9, 1e-9).value,
              2e-9);
  EXPECT_NEAR(*stationary_mean(p, f, 1e-9).value, *stationary_mean(other, turned_f, 1e-9).value, 2e-9);
  EXPECT_NEAR(*spectral_gap(p, 1e-8).value, *spectral_gap(other, 1e-8).value, 2e-8);
  const auto a = lyapunov(p, 1e-6), b = lyapunov(other, 1e-6);
  EXPECT_NEAR(*a.lambda1, *b.lambda1, 2e-6);
  EXPECT_NEAR(a.sum, b.sum, 2e-6);
}

// A multiple of the Casimir in h moves nothing, whatever its sign.
TEST(SphereProblem, AMultipleOfTheCasimirChangesNothing) {
  auto p = spin(), other = p;
  other.quadratic -= 3 * one;
  const auto f = [](const Vector3d& pi) { return pi[0] + pi[1] * pi[2]; };
  EXPECT_NEAR(*stationary_mean(p, f, 1e-9).value, *stationary_mean(other, f, 1e-9).value, 2e-9);
  EXPECT_NEAR(*lyapunov(p, 1e-6).lambda1, *lyapunov(other, 1e-6).lambda1, 2e-6);
  EXPECT_NEAR(p.spread(), other.spread(), 1e-14);
}

// Isotropic noise keeps exp(-2 damping h / sigma^2): a uniaxial spin, exp(chi x_3^2).
TEST(SphereProblem, AUniaxialSpinHasItsGibbsLaw) {
  const double chi = 4.867276891849686, sigma2 = 0.5, damping = 0.25;
  const sphere_problem p{Vector3d(0, 0, -chi * sigma2 / damping).asDiagonal(), damping, 1, sigma2 * one};
  const auto found = stationary_mean(p, *named_observable("pi3^2", p), 1e-10);
  ASSERT_TRUE(found.converged()) << found.reason;
  EXPECT_NEAR(*found.value, 0.757367637896, 1e-10);
}

// Without dissipation and anisotropy: precession in the field, while noise shrinks the mean.
TEST(SphereProblem, ASpinInAFieldPrecesses) {
  const Vector3d b(0.3, -0.7, 0.4);
  const sphere_problem p{Matrix3d::Zero(), 0, 1, 0.3 * one, b};
  const double t = 2;
  const Vector3d truth = std::exp(-0.3 * t) * (Eigen::AngleAxisd(-b.norm() * t, b.normalized()) * start);
  for (int k = 0; k < 3; ++k) {
    const auto found = expectation(
        p, [k](const Vector3d& pi) { return pi[k]; }, start, t, 1e-11);
    EXPECT_NEAR(*found.value, truth[k], 1e-10);
  }
}

// The gradient flow of a linear function is conformal: both exponents are half their sum, and the law of b.x is known.
TEST(SphereProblem, AFieldAloneStretchesAllDirectionsAlike) {
  const double b = 0.8, damping = 0.5, sigma2 = 0.4, c = 1.5, x = 2 * damping * b * c / sigma2;
  const sphere_problem p{Matrix3d::Zero(), damping, c, sigma2 * one, b * Vector3d(2, -1, 2) / 3};
  const double mean = -c * b * (1 / std::tanh(x) - 1 / x);  // E[b.Pi], Langevin
  const auto found = lyapunov(p, 1e-9);
  EXPECT_NEAR(found.sum, 2 * damping * mean, 1e-9);
  EXPECT_NEAR(*found.lambda1, damping * mean, 1e-9);
}

// sigma_i(Pi) = sigma (e_i + alpha Pi x e_i / |Pi|): the generator is that of constant noise of strength
// sigma sqrt(1 + alpha^2).
TEST(SphereProblem, NoiseInsideTheDampingIsStrongerConstantNoise) {
  const double sigma = 0.4, alpha = 0.7;
  for (const double c : {1.0, 2.0}) {
    auto p = spin();
    p.radius = c;
    auto constant = p;
    constant.covariance = sigma * sigma * (1 + alpha * alpha) * one;
    p.covariance.setZero();
    for (int i = 0; i < 3; ++i) {
      const Vector3d e = Vector3d::Unit(i);
      Matrix3d slope;  // Pi -> Pi x e
      slope << 0, e[2], -e[1], -e[2], 0, e[0], e[1], -e[0], 0;
      p.varying.push_back({sigma * e, sigma * alpha / c * slope});
    }
    const Eigen::MatrixXd varying = backward_operator(p, 8), truth = backward_operator(constant, 8);
    EXPECT_LT((varying - truth).cwiseAbs().maxCoeff(), 3e-13 * truth.cwiseAbs().maxCoeff());
    EXPECT_FALSE(lyapunov(p, 1e-6).lambda1);
  }
}

TEST(SphereProblem, WhereNoLawIsUnique) {
  const Vector3d n = Vector3d(1, 2, 2) / 3;
  const Matrix3d figure = n * n.transpose();
  EXPECT_TRUE(conserves_a_component({one + 2 * figure, 0, 1, figure, 0.3 * n}));
  EXPECT_FALSE(conserves_a_component({one + 2 * figure, 0.1, 1, figure, 0.3 * n}));     // damped
  EXPECT_FALSE(conserves_a_component({one + 2 * figure, 0, 1, figure, {0.1, 0, 0}}));   // field across
  EXPECT_FALSE(conserves_a_component({Vector3d(1, 2, 3).asDiagonal(), 0, 1, figure}));  // no body of revolution
  EXPECT_NE(no_unique_law({one + 2 * figure, 0.1, 1, figure, 0.3 * n}).find("equilibrium"), std::string::npos);
  EXPECT_EQ(no_unique_law({one + 2 * figure, 0.1, 1, figure, {0.1, 0, 0}}), "");
  EXPECT_EQ(no_unique_law(spin()), "");
}

// sigma(Pi) = e_1 - (n.Pi / c) e_1 vanishes at c n, on an axis of the body.
TEST(SphereProblem, NoiseThatVanishesAtAnEquilibriumHasNoUniqueLaw) {
  const Vector3d n = Vector3d::UnitZ(), e = Vector3d::UnitX();
  for (const double c : {1.0, 3.0}) {
    sphere_problem p{Vector3d(1, 2, 3).asDiagonal(), 0.2, c, Matrix3d::Zero()};
    p.varying = {{e, -(1 / c) * e * n.transpose()}};
    EXPECT_NE(no_unique_law(p).find("all noise vanishes"), std::string::npos) << c;
    p.covariance = 0.5 * one;
    EXPECT_EQ(no_unique_law(p), "") << c;
    p.covariance.setZero();
    p.varying.push_back({Vector3d::UnitY(), Matrix3d::Zero()});
    EXPECT_EQ(no_unique_law(p), "") << c;
  }
}

}  // namespace
}  // namespace polhode::test
