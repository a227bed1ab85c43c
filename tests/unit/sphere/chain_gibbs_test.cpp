// SPDX-License-Identifier: Apache-2.0
// The Gibbs law of coupled spins, by transfer matrices, against closed forms and sums over all points of all spheres.
#include <gtest/gtest.h>

#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <numbers>

#include "sphere/closed_forms/chain_gibbs.hpp"
#include "sphere/harmonics/harmonics.hpp"

namespace polhode {
namespace {

/// coth x - 1/x.
double langevin(double x) { return 1 / std::tanh(x) - 1 / x; }

chain_site free_spin(double length = 1) { return {Eigen::Matrix3d::Zero(), Eigen::Vector3d::Zero(), length}; }

Eigen::MatrixXd chain(int count, double strength) {
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(count, count);
  for (int i = 0; i + 1 < count; ++i) out(i, i + 1) = out(i + 1, i) = strength;
  return out;
}

double mean(const chain_gibbs& law, std::string_view name, double within = 1e-11) {
  const auto found = law.mean(name);
  EXPECT_TRUE(found && found->value) << name;
  if (!found || !found->value) return NAN;
  EXPECT_LE(found->uncertainty, within) << name;
  EXPECT_EQ(found->reason, "") << name;
  return *found->value;
}

TEST(ChainGibbs, OfTwoBoundSpinsIsTheClosedForm) {
  const chain_gibbs law{{free_spin(), free_spin()}, chain(2, 1), 10};
  EXPECT_NEAR(mean(law, "energy"), -0.9000000041, 1e-10);
  EXPECT_NEAR(mean(law, "energy"), -langevin(10), 1e-12);
  EXPECT_NEAR(mean(law, "s2_3"), 0, 1e-13);
  EXPECT_NEAR(mean(law, "s1_2^2"), 1.0 / 3, 1e-12);
}

TEST(ChainGibbs, OfAChainOfFreeSpinsHasIndependentBonds) {
  const chain_gibbs law{{free_spin(), free_spin(2), free_spin(0.5), free_spin()}, chain(4, -0.7), 3};
  EXPECT_NEAR(mean(law, "energy"), -1.4 * langevin(4.2) - 0.7 * langevin(2.1) - 0.35 * langevin(1.05), 1e-12);
}

TEST(ChainGibbs, OfSpinsInAFieldWithoutBondsIsLangevins) {
  const Eigen::Vector3d field(0, 0, 0.8);
  const chain_gibbs law{{{Eigen::Matrix3d::Zero(), field, 1}, {Eigen::Matrix3d::Zero(), field, 2}}, chain(2, 0), 2};
  EXPECT_NEAR(mean(law, "s1_3"), -langevin(1.6), 1e-12);
  EXPECT_NEAR(mean(law, "mu_6"), -2 * langevin(3.2), 1e-12);
  EXPECT_NEAR(mean(law, "energy"), -0.8 * langevin(1.6) - 1.6 * langevin(3.2), 1e-12);
}

/// Three of them on a ring or a chain of different bonds, by a sum over all points of three spheres.
struct summed {
  double energy = 0, component = 0, square = 0;
};
summed by_sums(const chain_gibbs& law, int degree) {
  const auto rule = sphere_quadrature(degree);
  const auto n = rule.weights.size();
  const auto spin = [&](std::size_t site, Eigen::Index i) -> Eigen::Vector3d {
    return law.sites[site].length * rule.points.row(i).transpose();
  };
  const auto own = [&](std::size_t site, const Eigen::Vector3d& s) {
    return 0.5 * s.dot(law.sites[site].quadratic * s) + law.sites[site].field.dot(s);
  };
  summed out;
  double total = 0;
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      for (Eigen::Index k = 0; k < n; ++k) {
        const auto a = spin(0, i), b = spin(1, j), c = spin(2, k);
        const double h = own(0, a) + own(1, b) + own(2, c) + law.exchange(0, 1) * a.dot(b) +
                         law.exchange(1, 2) * b.dot(c) + law.exchange(0, 2) * a.dot(c);
        const double mass = rule.weights[i] * rule.weights[j] * rule.weights[k] * std::exp(-law.beta * h);
        total += mass;
        out.energy += mass * h;
        out.component += mass * c[2];
        out.square += mass * b[0] * b[0];
      }
  return {out.energy / total, out.component / total, out.square / total};
}

Eigen::Matrix3d tilted() {
  Eigen::Matrix3d out;
  out << 0.5, 0.2, 0, 0.2, -0.4, 0.1, 0, 0.1, 0.3;
  return out;
}

void expect_sums(const Eigen::Matrix3d& exchange,
                 const std::vector<chain_site>& sites = {{tilted(), {0.2, 0, 0.4}, 1},
                                                         {tilted(), {0, 0, 0.4}, 1.2},
                                                         free_spin(0.9)},
                 double beta = 1.1, int degree = 18) {
  const chain_gibbs law{sites, exchange, beta};
  const auto truth = by_sums(law, degree);
  EXPECT_NEAR(mean(law, "energy"), truth.energy, 1e-10);
  EXPECT_NEAR(mean(law, "s3_3"), truth.component, 1e-10);
  EXPECT_NEAR(mean(law, "mu_4^2"), truth.square, 1e-10);
}

TEST(ChainGibbs, OfARingIsWhatSumsOverAllPointsGive) {
  Eigen::Matrix3d ring;
  ring << 0, 0.6, -0.3, 0.6, 0, 0.5, -0.3, 0.5, 0;
  expect_sums(ring);
}

// Alike but for one thing: a bond, a length with bonds as strong, a field, a quadratic form.
TEST(ChainGibbs, OfARingThatIsNearlyUniformIsWhatSumsOverAllPointsGive) {
  const chain_site alike{tilted(), {0.2, 0, 0.4}, 1};
  const std::vector<chain_site> sites(3, alike);
  const Eigen::Matrix3d bonds = 0.6 * (Eigen::Matrix3d::Ones() - Eigen::Matrix3d::Identity());
  expect_sums(bonds, sites, 0.4, 14);
  auto changed = bonds;
  changed(0, 2) = changed(2, 0) = -0.3;
  expect_sums(changed, sites, 0.4, 14);
  auto longer = sites;
  longer[2].length = 1.5;
  changed = bonds;
  changed.row(2) /= 1.5;
  changed.col(2) /= 1.5;
  expect_sums(changed, longer, 0.4, 14);
  auto turned = sites;
  turned[2].field = {0.4, -0.5, 0};
  expect_sums(bonds, turned, 0.4, 14);
  auto stiffer = sites;
  stiffer[2].quadratic = 2 * tilted();
  expect_sums(bonds, stiffer, 0.4, 14);
}

TEST(ChainGibbs, OfAChainIsWhatSumsOverAllPointsGive) {
  Eigen::Matrix3d open;
  open << 0, 0, -0.3, 0, 0, 0.5, -0.3, 0.5, 0;
  expect_sums(open);
}

TEST(ChainGibbs, OfAUniformRingIsThatOfOneWithUnequalBondsThatAreEqual) {
  chain_gibbs law{std::vector<chain_site>(4, {Eigen::Vector3d(0, 0, -0.8).asDiagonal(), {0.3, 0, 0}, 1}),
                  chain(4, -0.5), 1.5};
  law.exchange(0, 3) = law.exchange(3, 0) = -0.5;
  const double uniform = mean(law, "energy");
  law.exchange(0, 3) = law.exchange(3, 0) = -0.5 * (1 + 1e-13);
  EXPECT_NEAR(mean(law, "energy"), uniform, 1e-12);
}

// Joyce's: exp(-x cos) has the eigenvalues (-1)^l i_l(x), of a ring the trace of a power is taken.
TEST(ChainGibbs, OfARingOfFreeSpinsIsTheSumOverItsEigenvalues) {
  const auto i = [](int l, double x) {
    return l < 0 ? 0 : std::sqrt(std::numbers::pi / (2 * x)) * boost::math::cyl_bessel_i(l + 0.5, x);
  };
  for (const int count : {3, 4}) {
    chain_gibbs law{std::vector<chain_site>(static_cast<std::size_t>(count), free_spin()), chain(count, 1), 0.9};
    law.exchange(0, count - 1) = law.exchange(count - 1, 0) = 1;
    double sum = 0, slope = 0;
    for (int l = 0; l < 25; ++l) {
      const double sign = l % 2 == 0 ? 1 : -1, eigenvalue = sign * i(l, law.beta);
      sum += (2 * l + 1) * std::pow(eigenvalue, count);
      slope += sign * (l * i(l - 1, law.beta) + (l + 1) * i(l + 1, law.beta)) * count * std::pow(eigenvalue, count - 1);
    }
    EXPECT_NEAR(mean(law, "energy"), -slope / sum, 1e-12) << count;
  }
}

TEST(ChainGibbs, DoesNotLookAtTheDiagonalOfTheExchange) {
  chain_gibbs law{{free_spin(1.5), free_spin(0.8)}, chain(2, 0.7), 0.2};
  const auto without = *law.mean("energy");
  law.exchange.diagonal().setConstant(3);
  const auto with = *law.mean("energy");
  EXPECT_EQ(with.value, without.value);
  EXPECT_EQ(with.uncertainty, without.uncertainty);
}

TEST(ChainGibbs, OfLongSpinsIsAsWellKnown) {
  const chain_gibbs law{{free_spin(1e3), free_spin(2e3)}, chain(2, 0.7), 1e-6};
  EXPECT_NEAR(mean(law, "energy", 1e-6), -1.4e6 * langevin(1.4), 1e-6);
}

TEST(ChainGibbs, NoSiteMayHaveMoreThanTwoBonds) {
  const auto solvable = [](const Eigen::MatrixXd& exchange) {
    return chain_gibbs{std::vector<chain_site>(static_cast<std::size_t>(exchange.rows()), free_spin()), exchange, 1}
        .solvable();
  };
  for (Eigen::Index centre = 0; centre < 4; ++centre) {
    Eigen::MatrixXd star = Eigen::MatrixXd::Zero(4, 4);
    for (Eigen::Index i = 0; i < 4; ++i)
      if (i != centre) star(i, centre) = star(centre, i) = 0.5;
    EXPECT_FALSE(solvable(star)) << centre;
  }
  auto ring = chain(4, 1);
  EXPECT_TRUE(solvable(ring));
  ring(0, 3) = ring(3, 0) = 1;
  EXPECT_TRUE(solvable(ring));
}

// Where doubling the points changes nothing, the uncertainty is rounding of the observable's size. All points are
// alike.
TEST(ChainGibbs, IsAsUncertainAsRounding) {
  Eigen::Matrix3d tilted, exchange;
  tilted << 0.5, 0.2, 0, 0.2, -0.4, 0.1, 0, 0.1, 0.3;
  exchange << 0, 0.3, 0, 0.3, 0, -0.5, 0, -0.5, 0;
  const chain_gibbs law{{{tilted, {0.2, 0, 0.4}, 1.5}, {2 * tilted, {0, 0.3, 0}, 1.2}, free_spin(0.9)}, exchange, 0};
  const double own = 0.5 * tilted.norm() * 1.5 * 1.5 + std::sqrt(0.2) * 1.5 + tilted.norm() * 1.2 * 1.2 + 0.3 * 1.2,
               bonds = 0.3 * 1.5 * 1.2 + 0.5 * 1.2 * 0.9;
  EXPECT_DOUBLE_EQ(law.mean("energy")->uncertainty, 1e-14 * (own + bonds));
  EXPECT_DOUBLE_EQ(law.mean("s2_1^2")->uncertainty, 1e-14 * 1.44);
  EXPECT_DOUBLE_EQ(law.mean("s3_2")->uncertainty, 1e-14 * 0.9);
}

TEST(ChainGibbs, KnowsWhatItCannotSolve) {
  const chain_gibbs law{std::vector<chain_site>(4, free_spin()), Eigen::MatrixXd::Ones(4, 4), 1};
  EXPECT_FALSE(law.solvable());
  EXPECT_FALSE(law.mean("s5_1"));
  EXPECT_FALSE(law.mean("pi1"));
}

// The rule of degree 128 against that of 64.
TEST(ChainGibbs, WhereTheLawIsTooNarrowItIsAsUncertainAsTheLastDoubling) {
  const double field = 3000;
  const auto sum = [=](int degree) {
    const auto rule = sphere_quadrature(degree);
    const Eigen::ArrayXd z = rule.points.col(2), mass = rule.weights.array() * (-field * (z + 1)).exp();
    return (mass * z).sum() / mass.sum();
  };
  const chain_gibbs law{{{Eigen::Matrix3d::Zero(), {0, 0, field}, 1}}, Eigen::MatrixXd::Zero(1, 1), 1};
  const auto found = *law.mean("s1_3");
  EXPECT_NE(found.reason, "");
  EXPECT_NEAR(*found.value, sum(128), 1e-12);
  EXPECT_GT(found.uncertainty, 1e-7);
  EXPECT_NEAR(found.uncertainty, std::fabs(sum(128) - sum(64)), 1e-12);
}

// By its bonds, too. On a ring, as its degrees end at 40; up to which one a chain is doubled, the test before tells.
TEST(ChainGibbs, SaysSoWhereTheLawIsTooNarrow) {
  chain_gibbs law{std::vector<chain_site>(3, free_spin()), chain(3, 1), 1e5};
  law.exchange(0, 2) = law.exchange(2, 0) = 1;
  const auto found = law.mean("energy");
  ASSERT_TRUE(found);
  EXPECT_NE(found->reason, "");
}

}  // namespace
}  // namespace polhode
