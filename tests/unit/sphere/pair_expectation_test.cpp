// SPDX-License-Identifier: Apache-2.0
// Expectations on a product of two spheres: against those of one sphere, closed forms, the Gibbs law, and their own
// bars.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "algebra/exponential_action.hpp"
#include "sphere/closed_forms/chain_gibbs.hpp"
#include "sphere/galerkin/poisson.hpp"
#include "sphere/harmonics/backward_operator.hpp"
#include "sphere/harmonics/harmonics.hpp"
#include "sphere/products/pair_generator.hpp"
#include "support/dense.hpp"
#include "unit/sphere/pairs.hpp"

namespace polhode::test {
namespace {

/// E[f] at that degree, f given by its coefficients.
double propagated_at(const sphere_pair& pair, const momenta& start, double time, int degree, const Eigen::VectorXd& f) {
  const suprema_of_basis suprema{[](const Eigen::VectorXd& g) { return pair_supremum(g); },
                                 [=](const Eigen::VectorXd& g) { return pair_supremum(g, degree + 1); },
                                 unit_of_pair_mean};
  const auto y = pair_harmonics_at(start.head<3>().normalized(), start.tail<3>().normalized(), degree);
  return propagated(tall_backward_operator(pair, degree), f, y, time, suprema)->found.value;
}

TEST(PairHarmonics, AreOrderedByDegree) {
  const auto low = pair_harmonics_at(first, second, 3), high = pair_harmonics_at(first, second, 5);
  ASSERT_EQ(low.size(), pair_harmonic_count(3));
  ASSERT_EQ(high.size(), pair_harmonic_count(5));
  EXPECT_EQ((high.head(low.size()) - low).cwiseAbs().maxCoeff(), 0);
  const auto k = harmonic_index(2, -1), n = harmonic_index(3, 2);
  EXPECT_NEAR(high[pair_index(5)(k, n)], harmonics_at(first, 3)[k] * harmonics_at(second, 3)[n], 1e-15);
}

TEST(PairHarmonics, CarryObservablesExactly) {
  auto pair = bodies();
  pair.sites[1].field = {0.3, -0.2, 0.5};
  const auto start = both(first, second);
  const auto value = [&](const char* name) {
    return pair_coefficients(pair, *site_observable_named(name, 2), 4).dot(pair_harmonics_at(first, second, 4));
  };
  EXPECT_NEAR(value("energy"), pair.energy(first, second), 1e-14);
  EXPECT_NEAR(value("s1_3"), start[2], 1e-14);
  EXPECT_NEAR(value("mu_6^2"), 0.36, 1e-14);
}

// x_1.x_2 is of unit vectors.
TEST(PairHarmonics, CarryTheExchangeOfAnyLengths) {
  auto pair = bodies();
  pair.sites[0].radius = 1.5;
  pair.sites[1].radius = 0.7;
  const double found =
      pair_coefficients(pair, *site_observable_named("energy", 2), 3).dot(pair_harmonics_at(first, second, 3));
  EXPECT_NEAR(found, pair.energy(1.5 * first, 0.7 * second), 1e-14);
}

TEST(PairExpectation, ItsGeneratorReachesTwoDegreesFurther) {
  const auto generator = tall_backward_operator(bodies(), 3);
  EXPECT_EQ(generator.rows(), pair_harmonic_count(5));
  EXPECT_EQ(generator.cols(), pair_harmonic_count(3));
}

// A product of functions of both has the product of their expectations.
TEST(PairExpectation, WithoutExchangeIsTheProductOfTwoSpheres) {
  sphere_pair pair{
      {body_on_sphere({1, 1.2, 1.5}, 0.3, 1, 0.6 * one), body_on_sphere({1.1, 1, 1.3}, 0.2, 2, oblique())}};
  pair.sites[1].field = {0.1, 0, 0.2};
  const auto start = both(first, 2 * second);
  const double time = 0.1;
  const int degree = 12, k = harmonic_index(1, 0), n = harmonic_index(2, 1);
  Eigen::VectorXd f = Eigen::VectorXd::Zero(pair_harmonic_count(degree));
  f[pair_index(degree)(k, n)] = 1;
  const auto alone = [&](int site, int harmonic, const Eigen::Vector3d& from) {
    const auto& p = pair.sites[static_cast<std::size_t>(site)];
    const auto y = [&](const Eigen::Vector3d& pi) { return harmonics_at(pi / p.radius, 2)[harmonic]; };
    return *expectation(p, y, from, time, 1e-13).value;
  };
  EXPECT_NEAR(propagated_at(pair, start, time, degree, f), alone(0, k, first) * alone(1, n, 2 * second), 1e-12);
  const auto square = expected(pair, start, time, "mu_5^2", 1e-12);
  const auto f5 = [](const Eigen::Vector3d& pi) { return pi[1] * pi[1]; };
  holds(square, *expectation(pair.sites[1], f5, 2 * second, time, 1e-13).value, 4e-12);
}

// What cancels is not there: it would tie blocks together that have nothing to say to each other.
TEST(PairExpectation, OfItsGeneratorNoEntryIsRounding) {
  for (const auto& pair : {bound(0.8, 0, 0.7, true), bound(0.8, 0.5, 0.7, false), bodies()}) {
    const auto generator = tall_backward_operator(pair, 4);
    double least = 1;
    for (Eigen::Index column = 0; column < generator.cols(); ++column)
      for (sparse_matrix::InnerIterator entry(generator, column); entry; ++entry)
        least = std::min(least, std::fabs(entry.value()));
    EXPECT_GT(least, 1e-6);
  }
}

// d(S_1.S_2) = 0 by exchange alone; noise of its own turns each away: E[S_1.S_2] = exp(-2 s t), E[S_1 + S_2] = exp(-s
// t), s = sigma^2, times the start. The same noise turns both alike, and their precession about the sum stays.
TEST(PairExpectation, OfBoundSpinsWithoutDissipation) {
  const double exchange = 0.8, sigma = 0.7, time = 0.9, decay = std::exp(-sigma * sigma * time);
  const auto start = both(first, second);
  const auto own = bound(exchange, 0, sigma, false), same = bound(exchange, 0, sigma, true);
  holds(expected(own, start, time, "energy", 1e-13), decay * decay * exchange * first.dot(second), 1e-13);
  holds(expected(same, start, time, "energy", 1e-13), exchange * first.dot(second), 1e-13);
  const Eigen::Vector3d sum = first + second;
  const Eigen::Vector3d turned = Eigen::AngleAxisd(-exchange * sum.norm() * time, sum.normalized()) * first;
  for (int axis = 0; axis < 3; ++axis) {
    const auto name = "mu_" + std::to_string(axis + 1), other = "mu_" + std::to_string(axis + 4);
    const auto a = expected(own, start, time, name.c_str(), 1e-9), b = expected(own, start, time, other.c_str(), 1e-9);
    EXPECT_NEAR(*a.value + *b.value, decay * sum[axis], 1e-8);
    holds(expected(same, start, time, name.c_str(), 1e-9), decay * turned[axis], 1e-9);
  }
}

// In any unit: exchange, and noise that is shared, of one; or all of it ten thousand million times slower.
TEST(PairExpectation, OfBoundSpinsInAnyUnit) {
  for (const double unit : {1.0, 1e-10}) {
    const double time = 0.9 / unit;
    const auto pair = bound(unit, 0, std::sqrt(unit), true);
    const Eigen::Vector3d sum = first + second;
    const Eigen::Vector3d turned = Eigen::AngleAxisd(-unit * sum.norm() * time, sum.normalized()) * first;
    for (int axis = 0; axis < 3; ++axis)
      holds(expected(pair, both(first, second), time, ("mu_" + std::to_string(axis + 1)).c_str(), 1e-7),
            std::exp(-0.9) * turned[axis], 1e-7);
    EXPECT_NEAR(*expected(pair, both(first, second), time, "energy", 1e-13).value / unit, first.dot(second), 1e-13);
  }
}

// Short spins are not nothing.
TEST(PairExpectation, OfShortSpinsDecays) {
  const double length = 1e-3, sigma = 0.7, time = 0.4;
  auto pair = bound(0, 0, sigma, false);
  for (auto& site : pair.sites) site.radius = length;
  const auto found = expected(pair, length * both(first, second), time, "mu_3", 1e-12);
  holds(found, length * std::exp(-sigma * sigma * time) * first[2], 1e-14);
}

// u = S_1.S_2 of two unit spins under the same noise: u' = -2 theta J (1 - u^2), whatever the noise.
TEST(PairExpectation, DissipationDrawsBoundSpinsApart) {
  const double exchange = 0.8, damping = 0.5, time = 0.25, u = first.dot(second);
  const double after = std::tanh(std::atanh(u) - 2 * damping * exchange * time);
  holds(expected(bound(exchange, damping, 0.5, true), both(first, second), time, "energy", 1e-8), exchange * after,
        1e-8);
}

// Noise that turns both in any way: E[S_1 S_2^T] obeys a linear equation by itself.
TEST(PairExpectation, SharedNoiseIsThatOfItsVectors) {
  Eigen::Matrix<double, 6, 2> sigma;
  sigma << 0.5, 0.1, -0.2, 0.3, 0.4, 0, 0.1, -0.6, 0.3, 0.2, 0, 0.5;
  const Eigen::Matrix<double, 6, 6> covariance = sigma * sigma.transpose();
  const sphere_pair pair{{sphere_problem{none, 0, 1, covariance.topLeftCorner<3, 3>()},
                          sphere_problem{none, 0, 1, covariance.bottomRightCorner<3, 3>()}},
                         0,
                         covariance.topRightCorner<3, 3>()};
  Eigen::MatrixXd generator = Eigen::MatrixXd::Zero(9, 9), flow(9, 9);
  for (int k = 0; k < 2; ++k) {
    const Eigen::Vector3d on_first = sigma.col(k).head<3>(), on_second = sigma.col(k).tail<3>();
    for (int i = 0; i < 9; ++i) {  // of e_a e_b^T, column by column
      const Eigen::Vector3d a = Eigen::Vector3d::Unit(i % 3), b = Eigen::Vector3d::Unit(i / 3);
      const Eigen::Matrix3d moved = a.cross(on_first) * b.transpose() + a * b.cross(on_second).transpose();
      flow.col(i) = Eigen::Map<const Eigen::VectorXd>(moved.data(), 9);
    }
    generator += flow * flow / 2;
  }
  const double time = 1.3;
  const Eigen::Matrix3d start = first * second.transpose();
  const Eigen::VectorXd after = exponential_of(time * generator) * Eigen::Map<const Eigen::VectorXd>(start.data(), 9);
  Eigen::VectorXd f = Eigen::VectorXd::Zero(pair_harmonic_count(2));
  f[pair_index(2)(harmonic_index(1, 0), harmonic_index(1, 1))] =
      4 * std::numbers::pi / 3;  // x_3 of one, x_1 of the other
  EXPECT_NEAR(propagated_at(pair, both(first, second), time, 2, f), after[2], 1e-13);
}

// Poisson's equation of the generator has the Gibbs law's means, within a bar that it proves.
TEST(PairExpectation, TheGibbsLawIsStationary) {
  const double sigma = 1, theta = 0.1;
  const Eigen::Matrix3d quadratic = Eigen::Vector3d(0.2, 0, -0.4).asDiagonal();
  const Eigen::Vector3d field(0, 0, 0.3);
  const sphere_problem site{quadratic, theta, 1, sigma * sigma * one, field};
  auto other = site;
  other.radius = 0.8;
  const sphere_pair pair{{site, other}, 0.5};
  const chain_gibbs law{{{quadratic, field, 1}, {quadratic, field, 0.8}}, 0.5 * Eigen::Matrix2d::Ones(), 2 * theta};
  const auto tall = tall_backward_operator(pair, 8);
  for (const char* name : {"energy", "s1_3", "s2_1^2"}) {
    const auto f = pair_coefficients(pair, *site_observable_named(name, 2), 8);
    const auto found = poisson_mean(tall, f, 2000, [](const Eigen::VectorXd& g) { return pair_supremum(g); });
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->value / unit_of_pair_mean, *law.mean(name)->value, 1e-9) << name;
    EXPECT_LT(found->bound, 1e-4);
    EXPECT_GE(found->bound, std::fabs(found->value / unit_of_pair_mean - *law.mean(name)->value));
  }
}

TEST(PairExpectation, ProvedBarsHoldAtEveryDegree) {
  const auto start = both(first, second);
  pair_expectations exact(bodies(), start, 0.5);
  for (const char* name : {"energy", "mu_6^2"}) {
    const auto f = *site_observable_named(name, 2);
    const auto best = exact.of(f, 1e-8);
    ASSERT_TRUE(best.converged()) << best.reason;
    EXPECT_LE(best.uncertainty, 1e-8);
    const auto agreed = exact.agreed(f, 1e-6);
    holds(agreed, *best.value, 1e-6);
    EXPECT_LE(std::fabs(*agreed.value - *best.value), agreed.uncertainty + best.uncertainty) << name;
    double before = 1;
    for (const int degree : {2, 4, 6, 8, 10}) {
      const auto rough = exact.of(f, 1e-15, degree);
      ASSERT_TRUE(rough.value);
      EXPECT_EQ(rough.degree, degree);
      EXPECT_LE(std::fabs(*rough.value - *best.value), rough.uncertainty + best.uncertainty) << name << degree;
      EXPECT_LT(rough.uncertainty, before);
      before = rough.uncertainty;
    }
  }
}

// The site of which most is asked tells, in its field and that of its partner.
TEST(PairExpectation, SaysWhatDegreeTheHarderSiteWouldTake) {
  const sphere_problem hard{Eigen::Vector3d(1, 0.5, 0.2).asDiagonal(), 2, 0.8, 1e-6 * one, {0.1, -0.2, 0.2}};
  const sphere_problem easy{none, 0.1, 1.5, one};
  auto in_field = hard;
  in_field.field = {0, 0, hard.field.norm() + 0.4 * easy.radius};
  const auto words = not_converged(1, 4, needed_degree(in_field));
  const auto needed = words.substr(words.find(", and about"));
  for (const bool swapped : {false, true}) {
    const sphere_pair pair{{swapped ? easy : hard, swapped ? hard : easy}, -0.4};
    const auto start = swapped ? both(1.5 * second, 0.8 * first) : both(0.8 * first, 1.5 * second);
    pair_expectations low(pair, start, 3, 4);
    const auto found = low.of({.site = swapped ? 1 : 0, .axis = 2}, 1e-12);
    EXPECT_NE(found.reason.find(needed), std::string::npos) << found.reason << " for" << needed;
  }
}

// c.law, both of known length at time zero: of the law's harmonics 1 / 4 pi times the root of their number.
TEST(PairExpectation, ByAgreementIsNeverMoreCertainThanRounding) {
  auto pair = bound(0.8, 0.5, 0.7, false);
  pair.sites[0].radius = 3;
  pair_expectations at_once(pair, both(3 * first, second), 0);
  const auto found = at_once.agreed({.site = 0, .axis = 2}, 1e-9);
  EXPECT_NEAR(*found.value, 3 * first[2], 1e-14);
  EXPECT_NEAR(found.uncertainty, 1e-14 * 3 * std::sqrt(pair_harmonic_count(found.degree) / 3.0), 1e-20);
}

// Ten thousand million multiplications, counted at the lowest degree.
TEST(PairExpectation, ByAgreementGivesUpWhereThatTakesTooLong) {
  const auto pair = bound(0.8, 0.5, 0.7, false);
  const auto tall = tall_backward_operator(pair, 4);
  const sparse_matrix forward = tall.topRows(tall.cols()).transpose();
  const double time =
      1.1e10 / (exponential_action_products(forward, 1e6) * static_cast<double>(forward.nonZeros())) * 1e6;
  const auto found = pair_expectations(pair, both(first, second), time).agreed({.site = 0, .axis = 2}, 1e-9);
  EXPECT_FALSE(found.value);
  EXPECT_NE(found.reason.find("no affordable degree answers"), std::string::npos) << found.reason;
}

TEST(PairExpectation, SaysWhereNoDegreeWillDo) {
  pair_expectations faint(bound(5, 0.5, 0.01, false), both(first, second), 3, 8);
  const auto found = faint.of({.site = 1, .axis = 2}, 1e-4);
  EXPECT_FALSE(found.converged());
  EXPECT_NE(found.reason.find("not converged"), std::string::npos) << found.reason;
  EXPECT_TRUE(!found.value || found.uncertainty > 1e-4);
}

TEST(PairExpectation, NoiseOnOneOfThemIsNoise) {
  auto pair = bound(0.8, 0.5, 0, false);
  EXPECT_FALSE(pair.has_noise());
  pair.sites[1].covariance = one;
  EXPECT_TRUE(pair.has_noise());
  std::swap(pair.sites[0], pair.sites[1]);
  EXPECT_TRUE(pair.has_noise());
}

}  // namespace
}  // namespace polhode::test
