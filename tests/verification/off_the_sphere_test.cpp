// SPDX-License-Identifier: Apache-2.0
// weak and gibbs on systems that live on no sphere, against closed forms and planted defects.
#include <gtest/gtest.h>

#include <cmath>

#include "experiments/gibbs/relaxation.hpp"
#include "experiments/weak/weak_sampled.hpp"
#include "run/run_experiment.hpp"
#include "scene/scene.hpp"
#include "support/verdicts.hpp"

namespace polhode {
namespace {

using report::verdict_kind;

/// Two spins that nothing moves but isotropic noise.
report::scene two_free_spins(double sigma) {
  auto scene = load_scene("spin_pair");
  scene.vectors("quadratic") = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  scene.vector("field") = {0, 0, 0};
  scene.vectors("exchange") = {{0, 0}, {0, 0}};
  scene.horizon = 0.25;
  return with_dissipation(with_noise_times(scene, sigma / 0.4), 0);
}

// The rotation by sigma dt^1/2 g has the mean (1 + 2 (1 - s) exp(-s/2)) / 3, s = sigma^2 dt, on vectors; the true one
// is exp(-s).
TEST(OffTheSphere, SampledWeakErrorsAreThoseOfTheRotation) {
  constexpr double sigma = 1;
  const auto s = restricted(bind_scene(two_free_spins(sigma)), {"lie_euler", "magnus"});
  ASSERT_EQ(s.model->noise(), noise_class::isotropic);
  report::results out;
  report_sampled_orders(
      {s, effort::quick, 2, 3}, s.schemes, {{"s1_3", *observable_of(s, "s1_3")}}, [](const scheme_entry&) { return 1; },
      out);
  int compared = 0;
  for (const auto& m : out.measurements) {
    if (m.quantity != "difference" || m.observable != "s1_3" || m.scheme != "lie_euler") continue;
    const double dt = *m.dt(), x = sigma * sigma * dt, mean = (1 + 2 * (1 - x) * std::exp(-x / 2)) / 3;
    const double time = std::min(s.scene.horizon, 4 / s.offers->rates.fastest());
    const double exact = 0.8 * (std::pow(mean, std::round(time / dt)) - std::exp(-sigma * sigma * time));
    EXPECT_NEAR(*m.value, std::fabs(exact), 2 * (*m.high - *m.value)) << dt;  // four standard errors
    ++compared;
  }
  EXPECT_GE(compared, 6);
  for (const auto& v : out.verdicts) {
    EXPECT_NE(v.kind, verdict_kind::refuted) << v.scheme << ", " << v.claim << ": " << v.reason;
    if (v.scheme == "lie_euler") {
      EXPECT_EQ(v.kind, verdict_kind::holds) << v.claim << ": " << v.reason;
    }
  }
}

report::results weak_orders(const subject& s) {
  report::results out;
  report_sampled_orders(
      {s, effort::quick, 2, 3}, s.schemes, observables_of(s, 6), [](const scheme_entry&) { return 1; }, out);
  return out;
}

// Two ways to the same means that share nothing but the scene: paths, and linear algebra on both spheres.
TEST(OffTheSphere, TheDrivenEquationHasTheExactMeans) {
  for (const char* scene : {"so4", "spin_pair"}) {
    const auto r = weak_orders(restricted(bind_scene(load_scene(scene)), {"lie_euler"}));
    int compared = 0, levels = 0;
    for (const auto& m : r.measurements) {
      if (m.quantity == "distance from the true mean") {
        EXPECT_LT(std::fabs(*m.value), 4) << scene << m.observable;
        ++compared;
      }
      if (m.quantity == "mean of the driven equation") {
        EXPECT_LT(*m.high - *m.low, 0.04) << scene << m.observable;
      }
      if (m.quantity == "error against the true mean") ++levels;
    }
    EXPECT_EQ(compared, 13) << scene;
    EXPECT_GE(levels, 6) << scene;
    for (const auto& v : r.verdicts) EXPECT_NE(v.kind, verdict_kind::refuted) << scene << v.claim << ": " << v.reason;
  }
}

// Paths that feel a fifth more noise than the equation that they are held to: nothing is concluded from them.
TEST(OffTheSphere, ADrivenEquationWithoutTheExactMeansDecidesNothing) {
  const auto healthy = restricted(bind_scene(load_scene("spin_pair")), {"lie_euler"});
  auto s = restricted(healthy.with(with_noise_times(healthy.scene, 1.2)), {"lie_euler"});
  s.offers = healthy.offers;
  int held = 0;
  for (const auto& v : weak_orders(s).verdicts)
    if (v.scheme == "lie_euler") {
      EXPECT_EQ(v.kind, verdict_kind::inconclusive) << v.claim << ": " << v.reason;
      EXPECT_NE(v.reason.find("does not have the exact means"), std::string::npos) << v.reason;
      ++held;
    }
  EXPECT_EQ(held, 2);
}

// Of a free spin a component is correlated like exp(-sigma^2 t), which no other observable outlasts.
TEST(OffTheSphere, APilotRunFindsTheAutocorrelationTime) {
  constexpr double sigma = 0.8;
  const auto s = bind_scene(two_free_spins(sigma));
  const auto found = relaxation_of({s, effort::quick, 2, 4}, observables_of(s, 6), 0.02, 1e5, 0);
  EXPECT_EQ(found.reason, "");
  EXPECT_NEAR(found.time * sigma * sigma, 1, 0.35);  // the largest of six estimates, each to 13 %
  ASSERT_EQ(found.deviation.size(), 13u);
  EXPECT_NEAR(found.deviation[1], std::sqrt(1.0 / 3), 0.02);
  EXPECT_NEAR(found.deviation[7], std::sqrt(4.0 / 45), 0.02);
}

// Two wells, and a barrier that no path crosses in time.
TEST(OffTheSphere, AStartThatIsNotForgottenIsSeen) {
  auto scene = load_scene("spin_pair");
  scene.vectors("quadratic")[2][2] = -8;
  const auto s = restricted(bind_scene(scene), {"lie_euler"});
  const auto r = test::quick_results(s, {"gibbs"});
  bool said = false;
  for (const auto& v : r.verdicts) {
    EXPECT_NE(v.kind, verdict_kind::refuted) << v.claim << ": " << v.reason;
    said = said || v.reason.find("the start is not forgotten") != std::string::npos;
  }
  EXPECT_TRUE(said);
}

/// Of one scheme: the paths feel so many times the noise that the law and the steps are made for.
std::vector<report::verdict> gibbs_verdicts(const char* scene, double noise) {
  const auto healthy = restricted(bind_scene(load_scene(scene)), {"strang"});
  auto s = healthy.with(with_noise_times(healthy.scene, noise));
  s = restricted(s, {"strang"});
  s.offers = healthy.offers;
  std::vector<report::verdict> out;
  for (const auto& v : test::quick_results(s, {"gibbs"}).verdicts)
    if (v.scheme == "strang" && v.kind != verdict_kind::skipped) out.push_back(v);
  return out;
}

TEST(OffTheSphere, TheGibbsLawHolds) {
  for (const std::string scene : {"spin_pair", "maxwell_bloch"}) {
    const auto found = gibbs_verdicts(scene.c_str(), 1);
    ASSERT_EQ(found.size(), scene == "maxwell_bloch" ? 4u : 3u) << scene;  // of x_1 the whole law is known
    for (const auto& v : found) EXPECT_EQ(v.kind, verdict_kind::holds) << scene << ", " << v.claim << ": " << v.reason;
  }
}

TEST(OffTheSphere, NoiseATenthTooStrongIsRefuted) {
  for (const char* scene : {"spin_pair", "maxwell_bloch"})
    for (const auto& v : gibbs_verdicts(scene, 1.1))
      if (v.claim == "mean of energy") {
        EXPECT_EQ(v.kind, verdict_kind::refuted) << scene << ": " << v.reason;
      }
}

TEST(OffTheSphere, WithoutALawGibbsSaysWhy) {
  const auto reason = [](report::scene scene) {
    const auto r = test::quick_results(restricted(bind_scene(scene), {"strang"}), {"gibbs"});
    std::string all;
    for (const auto& s : r.skipped) all += s.reason + "; ";
    return all;
  };
  const auto top = load_scene("heavy_top");
  EXPECT_NE(reason(with_dissipation(top, 0)).find("not compact"), std::string::npos);
  EXPECT_NE(reason(with_noise_vectors(top, {{0.4, 0, 0, 0, 0, 0}})).find("not isotropic"), std::string::npos);
}

// Three vectors do not span so(4): the noise that weak order two adds beside them is of order 1/2 along a path, and
// gone as dt -> 0.
TEST(OffTheSphere, NoiseOfFewVectorsIsNoWrongLimit) {
  const auto scene = with_noise_vectors(
      load_scene("so4"), {{0.3, 0.2, -0.1, 0.2, 0.1, 0.3}, {0.1, -0.2, 0.3, 0, 0.2, -0.1}, {0, 0.4, 0, 0.1, 0, 0}});
  const auto r = test::quick_results(restricted(bind_scene(scene), {"strang_two_turns"}), {"strong"});
  const auto& limit = test::verdict_of(r, "limit is the Stratonovich solution");
  EXPECT_EQ(limit.kind, verdict_kind::holds) << limit.reason;
}

}  // namespace
}  // namespace polhode
