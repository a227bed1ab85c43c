#include "sphere/kolmogorov.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <map>

#include "algebra/exponential_action.hpp"
#include "algebra/sparse_blocks.hpp"
#include "sphere/closed_forms/gibbs.hpp"
#include "sphere/galerkin/raise_degree.hpp"
#include "support/dense.hpp"

namespace polhode::test {
namespace {

const Eigen::Vector3d start(0.6, 0.48, 0.64);

sphere_problem problem(double theta, const Eigen::Matrix3d& covariance) {
  return body_on_sphere({1, 2, 3}, theta, 1, covariance);
}
sphere_problem paper() { return problem(0.5, 0.25 * Eigen::Matrix3d::Identity()); }
sphere_function observable(std::string_view name) {
  return *named_observable(name, problem(0, Eigen::Matrix3d::Zero()));
}

Eigen::Matrix3d oblique() {
  Eigen::Matrix3d s;
  s << 0.5, 0.1, -0.2, 0, 0.3, 0.2, 0.1, 0, 0.6;
  return s * s.transpose();
}

void holds(const reference_value& found, double expected, double within) {
  ASSERT_TRUE(found.converged()) << found.reason;
  EXPECT_NEAR(*found.value, expected, within);
  EXPECT_LE(found.uncertainty, within);
}

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

TEST(Stationary, IsTheGibbsLawUnderIsotropicNoise) {
  const auto law = stationary(paper(), 1e-12);
  holds(mean(paper(), law, observable("energy")), 0.27662786228, 1e-11);
  holds(mean(paper(), law, observable("pi1^2")), 0.24176699009, 1e-11);
  holds(mean(paper(), law, observable("pi3^2")), 0.40576662289, 1e-11);
  const auto h = observable("energy");
  const auto second = mean(paper(), law, [&](const Eigen::Vector3d& pi) { return h(pi) * h(pi); });
  EXPECT_NEAR(*second.value - 0.27662786228 * 0.27662786228, 0.00637133262, 2e-11);
  for (const auto& [theta, sigma] : {std::pair{0.5, 0.15}, {2.0, 0.5}}) {
    const auto p = problem(theta, sigma * sigma * Eigen::Matrix3d::Identity());
    const gibbs_law gibbs({1, 2, 3}, 1, 2 * theta / (sigma * sigma));
    holds(mean(p, stationary(p, 1e-11), h), gibbs.mean_energy(), 1e-10);
  }
}

TEST(Stationary, IsUniformWithoutDissipation) {
  const auto p = problem(0, oblique());
  holds(mean(p, stationary(p, 1e-12), observable("energy")), (1 + 1 / 2.0 + 1 / 3.0) / 6, 1e-13);
}

TEST(Stationary, IsWhatALongTimeGivesForAnyNoise) {
  const auto p = problem(0.5, oblique());
  const auto law = stationary(p, 1e-12);
  for (const auto name : {"energy", "pi2", "exp(pi3)"}) {
    const auto late = expectation(p, observable(name), start, 150, 1e-11);
    EXPECT_FALSE(late.forgotten);  // found by the exponential, not by this law
    holds(mean(p, law, observable(name)), *late.value, 1e-10);
  }
}

TEST(Stationary, SaysWhereThereIsNoneOrMany) {
  EXPECT_FALSE(stationary(problem(0.5, Eigen::Matrix3d::Zero()), 1e-9).density);
  // Noise about the figure axis of a body of revolution keeps pi3.
  const auto top = body_on_sphere({2, 2, 3}, 0, 1, Eigen::Vector3d(0, 0, 0.25).asDiagonal());
  const auto law = stationary(top, 1e-9);
  EXPECT_FALSE(law.density);
  EXPECT_NE(law.reason.find("not unique"), std::string::npos);
}

TEST(SpectralGap, ScenePaperAndSphere) {
  holds(spectral_gap(paper(), 1e-12), 0.23706606686664, 1e-12);  // the independent program, degrees 14 to 20
  const auto round = body_on_sphere({2, 2, 2}, 0, 1, 0.25 * Eigen::Matrix3d::Identity());
  holds(spectral_gap(round, 1e-12), 0.25, 1e-12);
}

// Followed by inverse iteration beyond the dense degrees: the rate at which the last memory of the well fades.
TEST(SpectralGap, IsTheRateAtWhichExpectationsRelax) {
  const auto p = problem(0.5, 0.0144 * Eigen::Matrix3d::Identity());
  const auto gap = spectral_gap(p, 1e-11);
  ASSERT_TRUE(gap.converged()) << gap.reason << ' ' << gap.uncertainty;
  EXPECT_GT(gap.degree, 48);
  const auto at = [&](double t) { return *expectation(p, observable("pi3"), start, t, 1e-12).value; };
  EXPECT_NEAR(std::log(at(150) / at(250)) / 100, *gap.value, 1e-9);
}

TEST(SpectralGap, IsNotClaimedWhereItIsNotResolved) {
  EXPECT_FALSE(spectral_gap(problem(0.5, 0.0025 * Eigen::Matrix3d::Identity()), 1e-9).converged());
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

TEST(StationaryMean, BarsHoldAtEveryDegree) {
  for (const auto& q : {Eigen::Matrix3d(0.04 * Eigen::Matrix3d::Identity()), oblique()}) {
    const auto p = problem(0.5, q);
    const auto exact = stationary_mean(p, observable("energy"), 1e-11);
    holds(exact, *mean(p, stationary(p, 1e-11), observable("energy")).value, 1e-10);
    for (const int degree : {1, 4, 6, 8, 12}) {
      const auto rough = stationary_mean(p, observable("energy"), 1e-11, degree);
      if (!rough.value) continue;
      EXPECT_LE(std::fabs(*rough.value - *exact.value), rough.uncertainty + exact.uncertainty) << degree;
    }
  }
}

// Without dissipation h is an eigenfunction at every degree, of rate 3 sigma^2: it hid the slower odd mode, whose rate
// tends to 1.884 sigma^2 as the noise fades (diffusion averaged over the circles of equal energy).
TEST(SpectralGap, OddModeIsSlowerThanTheEnergyUnderWeakNoise) {
  double last = 0;
  for (const double sigma : {0.3, 0.2, 0.1}) {
    const auto gap = spectral_gap(problem(0, sigma * sigma * Eigen::Matrix3d::Identity()), 1e-9);
    ASSERT_TRUE(gap.converged()) << gap.reason;
    const double share = *gap.value / (sigma * sigma);
    EXPECT_GT(share, last);
    EXPECT_LT(share, 1.884);
    last = share;
  }
  EXPECT_NEAR(last, 1.5125744, 1e-6);  // dense, degree 48
}

TEST(SpectralGap, FaintNoiseIsRefusedWithTheDegreeItWouldTake) {
  for (const double sigma : {0.005, 0.001}) {
    const auto gap = spectral_gap(problem(0, sigma * sigma * Eigen::Matrix3d::Identity()), 1e-9);
    EXPECT_FALSE(gap.converged());
    EXPECT_NE(gap.reason.find(sigma > 0.002 ? "about 1600 would" : "about 8200 would"), std::string::npos)
        << gap.reason;
  }
}

// Every truncation has a null vector there, and it changes with the degree.
TEST(SpectralGap, IsZeroOnlyWhereSomethingIsConserved) {
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d axis = 0.5 * Eigen::Vector3d::Unit(k);
    const auto gap = spectral_gap(problem(0, axis * axis.transpose()), 1e-9);
    EXPECT_FALSE(gap.value);
    EXPECT_NE(gap.reason.find("rests for ever"), std::string::npos) << gap.reason;
    EXPECT_FALSE(stationary(problem(0.5, axis * axis.transpose()), 1e-9).density);
  }
  const Eigen::Matrix3d figure = Eigen::Vector3d(0, 0, 0.25).asDiagonal();
  EXPECT_EQ(*spectral_gap(body_on_sphere({2, 2, 3}, 0, 1, figure), 1e-9).value, 0);
  EXPECT_EQ(*spectral_gap(body_on_sphere({2, 2, 2}, 0.5, 1, figure), 1e-9).value, 0);
  EXPECT_FALSE(spectral_gap(body_on_sphere({2, 2, 3}, 0.5, 1, figure), 1e-9).converged());  // damped: not conserved
}

TEST(RaiseDegree, AgreementByAccidentIsNone) {
  const std::vector<int> degrees{8, 12, 16, 24, 32};
  const auto answer = [&](const std::map<int, double>& values, double needed) {
    return raise_degree(degrees, {.absolute = 1e-9, .size = 1}, needed, [&](int degree) {
      return std::optional(projected_value{values.at(degree), 1e-15});
    });
  };
  const auto accident = answer({{8, 1}, {12, 0.9}, {16, 0.9}, {24, 0.8}, {32, 0.75}}, 0);
  EXPECT_FALSE(accident.converged());
  EXPECT_GT(accident.uncertainty, 0.05);
  const auto frozen = answer({{8, 1}, {12, 1}, {16, 1}, {24, 1}, {32, 1}}, 1000);  // nothing is resolved
  EXPECT_FALSE(frozen.value);
  EXPECT_NE(frozen.reason.find("about 1000 would be needed"), std::string::npos) << frozen.reason;
  const auto settled = answer({{8, 1 + 1e-4}, {12, 1 + 1e-7}, {16, 1 + 1e-10}, {24, 1}, {32, 2}}, 30);
  ASSERT_TRUE(settled.converged());
  EXPECT_EQ(settled.degree, 24);
}

TEST(ExponentialAction, IsTheExponential) {
  const Eigen::MatrixXd a = 3 * Eigen::MatrixXd::Random(40, 40);
  const Eigen::VectorXd b = Eigen::VectorXd::Random(40);
  const Eigen::VectorXd dense = test::exponential_of(0.9 * a) * b;
  EXPECT_LT((exponential_action(a.sparseView(), 0.9, b) - dense).norm(), 1e-12 * dense.norm());
}

TEST(SparseBlocks, AreFoundAndInvariantVectorsSolved) {
  // Two chains on {0, 2, 3} and {1, 4}; columns of a backward generator act on functions, column 0 being the constant.
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(5, 5);
  a(2, 2) = a(3, 3) = a(1, 1) = a(4, 4) = -1;
  a(0, 2) = 0.5;
  a(2, 3) = 0.25;
  a(1, 4) = 0.1;
  const sparse_matrix s = a.sparseView();
  EXPECT_EQ(connected_blocks(s), (std::vector<index_set>{{0, 2, 3}, {1, 4}}));
  const auto nu = left_null_vector(s, 5);
  ASSERT_TRUE(nu);
  EXPECT_LT((*nu - (Eigen::VectorXd(5) << 1, 0, 0.5, 0.125, 0).finished()).norm(), 1e-15);
  EXPECT_FALSE(left_null_vector(s, 2));
}

}  // namespace
}  // namespace polhode::test
