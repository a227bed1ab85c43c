// `polhode reference` as a function: known answers, laws that hold whatever the method, and refusals in words.
#include "run/reference.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "reports/model/errors.hpp"
#include "run/verify.hpp"
#include "sphere/closed_forms/gibbs.hpp"
#include "sphere/harmonics.hpp"
#include "sphere/kolmogorov.hpp"
#include "support/dense.hpp"
#include "transfer/transfer.hpp"

namespace polhode::test {
namespace {

using three = std::vector<double>;

scene scene_of(three inertia, double theta, std::vector<three> sigma, double c = 1) {
  auto s = load_scene("paper");
  s.name = "given";
  s.vector("inertia") = inertia;
  s.number("theta") = theta;
  s.vectors("sigma") = std::move(sigma);
  s.momentum = {0.6 * c, 0.48 * c, 0.64 * c};
  return s;
}

std::vector<three> axes(double a, double b, double c) { return {{a, 0, 0}, {0, b, 0}, {0, 0, c}}; }
const std::vector<three> half = axes(0.5, 0.5, 0.5), two_vectors{{0.9, 0.2, 0}, {-0.1, 0.8, 0.5}};

/// Checked: converged, and as certain as the caller wants to compare.
reference_answer ask(const scene& s, reference_options o, double within = 1e-9) {
  const auto a = reference(s, o);
  EXPECT_EQ(a.reason, "") << o.quantity;
  EXPECT_LE(a.uncertainty, within) << o.quantity;
  return a;
}

double expected(const scene& s, const char* observable, double time) {
  return ask(s, {"expectation", observable, time, 0}).value;
}
double stationary_mean(const scene& s, const char* observable, int degree = 0) {
  return ask(s, {"gibbs", observable, {}, degree}).value;
}
double gap(const scene& s) { return ask(s, {"gap", {}, {}, 0}).value; }
reference_answer exponents(const scene& s) { return ask(s, {"lyapunov", {}, {}, 0}, 3e-7); }

std::string refusal(const scene& s, const reference_options& o) {
  try {
    reference(s, o);
  } catch (const input_error& e) {
    return e.what();
  }
  return "";
}

void refuses(const scene& s, const reference_options& o, const std::vector<std::string>& words) {
  const auto message = refusal(s, o);
  EXPECT_FALSE(message.empty()) << o.quantity << " was answered";
  EXPECT_EQ(message.find('\n'), message.npos) << message;
  for (const auto& word : words) EXPECT_NE(message.find(word), message.npos) << word << " in: " << message;
}

/// The scene with axis i called i + 1, and what belongs to it.
scene relabelled(scene s) {
  const auto turn = [](three& v) { v = {v[2], v[0], v[1]}; };
  turn(s.vector("inertia"));
  for (auto& v : s.vectors("sigma")) turn(v);
  s.momentum = {s.momentum[2], s.momentum[0], s.momentum[1]};
  return s;
}

const std::vector<scene> kinds{scene_of({1, 2, 3}, 0.5, half, 3),       scene_of({1, 1, 2.5}, 0, half),
                               scene_of({1, 10, 100}, 0.5, half),       scene_of({1, 2, 3}, 0.5, axes(0.2, 0.5, 0.9)),
                               scene_of({1, 2, 3}, 0.5, two_vectors),   scene_of({3, 3, 1}, 0.3, axes(0.4, 0.6, 0.5)),
                               scene_of({1, 2, 3}, 0.05, axes(1, 1, 1))};

// --- Known answers: an independent program, to the digits it printed.

TEST(Reference, KnownExpectations) {
  const std::vector<std::pair<const char*, double>> known{{"energy", 0.281221439758},
                                                          {"pi1", 0.22605229629},
                                                          {"pi2", 0.44478743232},
                                                          {"pi3", 0.32280817976},
                                                          {"exp(pi3)", 1.55190822842}};
  for (const auto& [name, value] : known)
    EXPECT_NEAR(ask(load_scene("paper"), {"expectation", name, {}, 0}).value, value, 6e-12) << name;
}

TEST(Reference, KnownStationaryMeansAndGap) {
  const auto paper = load_scene("paper");
  for (const int degree : {0, 32}) {
    EXPECT_NEAR(stationary_mean(paper, "energy", degree), 0.27662786228, 6e-12);
    EXPECT_NEAR(stationary_mean(paper, "pi1^2", degree), 0.24176699009, 6e-12);
    EXPECT_NEAR(stationary_mean(paper, "pi3^2", degree), 0.40576662289, 6e-12);
  }
  EXPECT_NEAR(gap(paper), 0.237066066867, 6e-13);
}

TEST(Reference, KnownExponents) {
  const auto a = exponents(load_scene("paper"));
  EXPECT_NEAR(a.value, 0.020196, 6e-7);
  EXPECT_NEAR(*a.sum, -0.0867830798, 6e-11);
  EXPECT_NEAR(*a.dimension, 1 + 0.020196 / (0.0867830798 + 0.020196), 6e-6);
  const auto quiet = exponents(scene_of({1, 2, 3}, 1, half));
  EXPECT_NEAR(quiet.value, -0.04358, 6e-6);
  EXPECT_EQ(*quiet.dimension, 0);
}

// --- Closed forms.

TEST(Reference, ASphericalBodyForgetsItsMomentumByTheNoiseAlone) {
  for (const auto& sigma : {half, axes(0.2, 0.5, 0.9), two_vectors}) {
    Eigen::Matrix3d decay = Eigen::Matrix3d::Zero();  // Ito's drift: half of (Pi x sigma) x sigma
    for (const auto& v : sigma) {
      const Eigen::Vector3d e(v[0], v[1], v[2]);
      decay += 0.5 * (e * e.transpose() - e.squaredNorm() * Eigen::Matrix3d::Identity());
    }
    const auto s = scene_of({2, 2, 2}, 0.5, sigma);
    const Eigen::Vector3d mean = test::exponential_of(1.7 * decay) * Eigen::Vector3d(0.6, 0.48, 0.64);
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(expected(s, std::array{"pi1", "pi2", "pi3"}[static_cast<std::size_t>(k)], 1.7), mean[k], 1e-12);
  }
}

TEST(Reference, ABodyOfRevolutionKeepsOrLosesItsFigureAxisByTheNoiseAlone) {
  const auto top = scene_of({1, 1, 2.5}, 0, half);
  for (const double t : {0.0, 0.4, 3.0}) {
    const double square = 1 / 3.0 + std::exp(-0.75 * t) * (0.64 * 0.64 - 1 / 3.0);
    EXPECT_NEAR(expected(top, "pi3", t), std::exp(-0.25 * t) * 0.64, 1e-13);
    EXPECT_NEAR(expected(top, "pi3^2", t), square, 1e-13);
    EXPECT_NEAR(expected(top, "energy", t), 0.5 * (1 - square) + square / 5, 1e-13);
  }
  EXPECT_NEAR(gap(top), 0.25, 1e-12);
  // Noise about the figure axis: the precession goes on, its phase diffuses.
  const auto phase = scene_of({1, 1, 2.5}, 0, {{0, 0, 0.4}});
  const double angle = 2 * 0.64 * (1 - 1 / 2.5), faded = std::exp(-0.16);
  EXPECT_NEAR(expected(phase, "pi1", 2), faded * (0.6 * std::cos(angle) - 0.48 * std::sin(angle)), 1e-12);
  EXPECT_NEAR(expected(phase, "pi2", 2), faded * (0.6 * std::sin(angle) + 0.48 * std::cos(angle)), 1e-12);
  EXPECT_EQ(gap(phase), 0);
}

// The Gibbs density summed over the sphere, for extreme bodies too.
TEST(Reference, IsotropicNoiseLeavesTheGibbsLaw) {
  const auto rule = sphere_quadrature(160);
  for (const auto& s : {kinds[0], kinds[2], kinds[6], scene_of({0.5, 4, 0.6}, 0.2, half, 2)}) {
    const double c = std::hypot(s.momentum[0], s.momentum[1], s.momentum[2]), sigma = s.vectors("sigma")[0][0];
    const Eigen::Array3d i(s.vector("inertia").data());
    const Eigen::ArrayXd h = 0.5 * c * c * (rule.points.array().square().matrix() * i.inverse().matrix()).array();
    const Eigen::ArrayXd weight =
        rule.weights.array() * (-2 * s.number("theta") / (sigma * sigma) * (h - h.minCoeff())).exp();
    const double mean = (weight * h).sum() / weight.sum();
    const double second = (weight * rule.points.col(1).array().square()).sum() / weight.sum() * c * c;
    EXPECT_NEAR(stationary_mean(s, "energy"), mean, 1e-10);
    EXPECT_NEAR(stationary_mean(s, "pi2^2"), second, 1e-9);
    EXPECT_NEAR(stationary_mean(s, "energy", 40), mean, 1e-9);
    const auto a = exponents(s);
    EXPECT_NEAR(*a.sum, -s.number("theta") * (c * c * i.inverse().sum() - 6 * mean), 1e-8);
  }
}

TEST(Reference, WithoutDissipationTheLawIsUniformForAnyNoise) {
  for (const auto& sigma : {half, axes(0.2, 0.5, 0.9), two_vectors}) {
    const auto s = scene_of({1, 2, 3}, 0, sigma, 3);
    EXPECT_NEAR(stationary_mean(s, "energy"), 9 * (1 + 1 / 2.0 + 1 / 3.0) / 6, 1e-10);
    EXPECT_NEAR(stationary_mean(s, "exp(pi3)"), std::sinh(3) / 3, 1e-10);
  }
  const auto a = exponents(scene_of({1, 2, 3}, 0, half));
  EXPECT_EQ(*a.sum, 0);
  EXPECT_EQ(*a.dimension, 2);
  EXPECT_GT(a.value, 0.01);
}

// --- Laws.

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
  for (const auto& s : {kinds[0], kinds[2], kinds[4]}) {
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

// --- Without noise.

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

// --- Refusals.

TEST(Reference, BadOptionsAreNamed) {
  const auto paper = load_scene("paper");
  refuses(paper, {"", {}, {}, 0}, {"--quantity", "expectation, gibbs, lyapunov, gap"});
  refuses(paper, {"gibs", {}, {}, 0}, {"--quantity 'gibs'", "did you mean 'gibbs'"});
  refuses(paper, {"line\nbreak", {}, {}, 0}, {"--quantity"});
  for (const char* quantity : {"expectation", "gibbs"}) {
    refuses(paper, {quantity, "enrgy", {}, 0}, {"--observable 'enrgy'", "did you mean 'energy'", "exp(pi3)"});
    refuses(paper, {quantity, "", {}, 0}, {"--observable ''", "casimir"});
    refuses(paper, {quantity, "pi4", {}, 0}, {"--observable 'pi4'"});
  }
  for (const int degree : {-1, 129}) refuses(paper, {"gap", {}, {}, degree}, {"--degree", "1 to 128"});
  for (const double time : {-1.0, std::nan(""), HUGE_VAL})
    refuses(paper, {"expectation", {}, time, 0}, {"--time", "at least 0"});
  for (const char* quantity : {"gibbs", "gap", "lyapunov"})
    refuses(paper, {quantity, {}, 1.0, 0}, {"--time '1'", quantity, "expectation"});
  for (const char* quantity : {"gap", "lyapunov"})
    refuses(paper, {quantity, "energy", {}, 0}, {"--observable", quantity});
}

TEST(Reference, WhereNoLawIsUniqueItIsSaid) {
  const auto phase = scene_of({1, 1, 2.5}, 0, {{0, 0, 0.4}});
  refuses(phase, {"gibbs", {}, {}, 0}, {"not unique"});
  refuses(phase, {"lyapunov", {}, {}, 0}, {"not unique"});
}

TEST(Reference, WhatNoDegreeResolvesIsRefusedWithTheDegreeItWouldTake) {
  const auto needle = scene_of({1e-6, 1, 2}, 0.5, half);
  for (const char* quantity : {"expectation", "gap"})
    refuses(needle, {quantity, {}, {}, 0}, {"given", quantity, "not converged", "about 21000 would be needed"});
  EXPECT_NEAR(stationary_mean(scene_of({1e-6, 1, 1}, 0.5, half), "energy"), 0.625, 1e-11);  // the law itself is known
}

TEST(Reference, AForcedDegreeSaysHowFarItIsOff) {
  const auto paper = load_scene("paper");
  const auto rough = reference(paper, {"expectation", {}, {}, 8});
  EXPECT_EQ(rough.degree, 8);
  EXPECT_NE(rough.reason, "");
  EXPECT_GT(rough.uncertainty, 1e-9);
  EXPECT_NEAR(rough.value, 0.281221439758, rough.uncertainty);
  const auto fine = reference(paper, {"expectation", {}, {}, 40});
  EXPECT_EQ(fine.degree, 40);
  EXPECT_EQ(fine.reason, "");
}

// Strong Gibbs factors see the last digit of nearly equal inertias: 1 / (1 / 1.9) is not 1.9.
TEST(Reference, GibbsTakesTheInertiaAsItStands) {
  const double near = 1.9;
  ASSERT_NE(1 / (1 / near), near);
  const three inertia{near * (1 + 1e-9), near, 1.2};
  const double beta = 2e10, theta = 0.5 * beta * 1e-6;
  const auto s = scene_of(inertia, theta, axes(1e-3, 1e-3, 1e-3));
  const gibbs_law law({inertia[0], inertia[1], inertia[2]}, 1, beta);
  for (const int k : {0, 1}) {
    const auto found = ask(s, {"gibbs", fmt::format("pi{}^2", k + 1), {}, 0});
    EXPECT_NEAR(found.value, law.mean_square(k), 1e-11 * law.mean_square(k));
  }
}

TEST(Reference, EveryListedObservableIsAnswered) {
  const auto listed = named_observables();
  EXPECT_EQ(listed.size(), 9u);
  for (const auto& o : listed) {
    const auto f = named_observable(o.name, *bind_scene(load_scene("paper")).sphere());
    ASSERT_TRUE(f) << o.name;
    EXPECT_NEAR(ask(load_scene("paper"), {"expectation", o.name, 0.0, 0}).value, (*f)({0.6, 0.48, 0.64}), 1e-11);
  }
}

}  // namespace
}  // namespace polhode::test
