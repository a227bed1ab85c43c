// SPDX-License-Identifier: Apache-2.0
// `polhode reference` as a function: laws that hold whatever the method, with noise and without.
#include "run/reference.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "sphere/expectations/expectation.hpp"
#include "sphere/stationary.hpp"
#include "unit/run/reference_questions.hpp"

namespace polhode::test {
namespace {

/// The scene with axis i called i + 1, and what belongs to it.
scene relabelled(scene s) {
  const auto turn = [](three& v) { v = {v[2], v[0], v[1]}; };
  turn(s.vector("inertia"));
  for (auto& v : s.vectors("sigma")) turn(v);
  s.momentum = {s.momentum[2], s.momentum[0], s.momentum[1]};
  return s;
}

// The basis singles out the third axis, a body does not.
TEST(Reference, NamesOfTheAxesDoNotMatter) {
  for (const auto& s : kinds) {
    const auto other = relabelled(s);
    for (const auto& [one, two] : {std::pair{"energy", "energy"}, {"pi1", "pi2"}, {"pi2^2", "pi3^2"}})
      EXPECT_NEAR(expected(s, one, 1.3), expected(other, two, 1.3), 2e-10) << one;
    EXPECT_NEAR(stationary_mean(s, "energy"), stationary_mean(other, "energy"), 2e-10);
    EXPECT_NEAR(gap(s), gap(other), 3e-9);
    EXPECT_NEAR(exponents(s).value, exponents(other).value, 6e-7);
  }
}

// Momentum c over time T is momentum 1 over time cT with theta c and sigma / sqrt(c).
TEST(Reference, ScalesWithTheMomentum) {
  const double c = 3;
  const auto large = scene_of({1, 2, 3}, 0.2, axes(0.2, 0.5, 0.9), c);
  auto unit = scene_of({1, 2, 3}, 0.2 * c, axes(0.2, 0.5, 0.9));
  for (auto& v : unit.vectors("sigma"))
    for (double& x : v) x /= std::sqrt(c);
  EXPECT_NEAR(expected(large, "energy", 0.8), c * c * expected(unit, "energy", 0.8 * c), 1e-9);
  EXPECT_NEAR(expected(large, "pi2", 0.8), c * expected(unit, "pi2", 0.8 * c), 1e-9);
  EXPECT_NEAR(stationary_mean(large, "pi3^2"), c * c * stationary_mean(unit, "pi3^2"), 1e-9);
  EXPECT_NEAR(gap(large), c * gap(unit), 1e-8);
  EXPECT_NEAR(exponents(large).value, c * exponents(unit).value, 1e-6);
  EXPECT_NEAR(*exponents(large).sum, c * *exponents(unit).sum, 1e-8);
}

// The exponential, 40 relaxation times on, against the stationary density, and the rate at which it gets there.
TEST(Reference, ALongTimeLeavesTheStationaryLawAtTheRateOfTheGap) {
  for (const auto& s : {kinds[2], kinds[3], kinds[4]}) {
    const double rate = gap(s), end = stationary_mean(s, "energy");
    EXPECT_NEAR(expected(s, "energy", 24 / rate), end, 1e-9);
    const auto later = [&](double t) { return std::fabs(expected(s, "exp(pi3)", t) - stationary_mean(s, "exp(pi3)")); };
    const double left = later(8 / rate);
    EXPECT_LT(left, 30 * std::exp(-8.0) * std::exp(s.momentum[2]));
    EXPECT_GT(later(1 / rate), left);
  }
}

TEST(Reference, AHorizonOfAMillionIsAnsweredByTheStationaryLaw) {
  const auto paper = load_scene("paper");
  const auto a = ask(paper, {"expectation", {}, 1e6, 0});
  EXPECT_NEAR(a.value, 0.27662786228, 6e-12);
  EXPECT_NE(a.method.find("stationary"), std::string::npos) << a.method;
  EXPECT_EQ(*a.time, 1e6);
  EXPECT_NEAR(expected(paper, "pi1", 1e300), 0, 1e-13);
  // Where something is never forgotten, it is not forgotten: pi3 is conserved.
  EXPECT_NEAR(expected(scene_of({1, 1, 2.5}, 0, {{0, 0, 0.4}}), "pi3", 1e4), 0.64, 1e-10);
}

TEST(Reference, WithoutNoiseTheExpectationIsThePath) {
  const three inertia{1, 2, 3}, start{0.6, 0.48, 0.64};
  for (const auto& sigma : {std::vector<three>{}, axes(0, 0, 0)})
    for (const double theta : {0.0, 0.5}) {
      // By steps of its own: the classical fourth-order method, error below 1e-11.
      Eigen::Vector3d pi(start[0], start[1], start[2]);
      const auto slope = [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
        const Eigen::Vector3d rate = p.array() / Eigen::Array3d(inertia.data());
        return p.cross(rate + theta * p.cross(rate));
      };
      const double dt = 2.0 / 2000;
      for (int n = 0; n < 2000; ++n) {
        const Eigen::Vector3d a = slope(pi), b = slope(pi + dt / 2 * a), c = slope(pi + dt / 2 * b),
                              d = slope(pi + dt * c);
        pi += dt / 6 * (a + 2 * b + 2 * c + d);
      }
      const auto s = scene_of(inertia, theta, sigma);
      for (int k = 0; k < 3; ++k) {
        const auto* name = std::array{"pi1", "pi2", "pi3"}[static_cast<std::size_t>(k)];
        EXPECT_NEAR(ask(s, {"expectation", name, {}, 0}, 1e-12).value, pi[k], 1e-11) << theta;
      }
    }
}

TEST(Reference, WithoutNoiseALongTimeIsFollowedToo) {
  const auto damped = scene_of({1, 2, 3}, 0.5, {});
  EXPECT_NEAR(expected(damped, "energy", 1e6), 1 / 6.0, 1e-12);  // the axis of least energy
  const auto free = ask(scene_of({1, 2, 3}, 0, {}), {"expectation", "energy", 1e4, 0}, 1e-8);
  EXPECT_NEAR(free.value, 0.18 + 0.48 * 0.48 / 4 + 0.64 * 0.64 / 6, 1e-10);
  refuses(damped, {"expectation", "energy", 1e300, 0}, {"given", "expectation", "turns", "1e+07"});
}

TEST(Reference, WithoutNoiseOtherQuestionsNameAndAnswerTheOneThatRemains) {
  const auto still = scene_of({1, 2, 3}, 0.5, {});
  const auto path = reference(still, {"expectation", {}, {}, 0});
  for (const char* quantity : {"gibbs", "gap", "lyapunov"}) {
    const auto answer = reference(still, {quantity, {}, {}, 0});
    EXPECT_EQ(answer.quantity, "expectation");
    EXPECT_EQ(answer.value, path.value);
    for (const char* part : {quantity, "no noise", "--quantity expectation"})
      EXPECT_NE(answer.reason.find(part), std::string::npos) << answer.reason;
  }
}

}  // namespace
}  // namespace polhode::test
