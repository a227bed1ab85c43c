// The stationary law on the sphere: Gibbs, uniform, what a long time gives, and none.
#include <gtest/gtest.h>

#include <cmath>

#include "sphere/closed_forms/gibbs.hpp"
#include "sphere/stationary.hpp"
#include "unit/sphere/problems.hpp"

namespace polhode::test {
namespace {

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

}  // namespace
}  // namespace polhode::test
