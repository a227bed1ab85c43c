// SPDX-License-Identifier: Apache-2.0
// The main job itself: claims hold on scenes of every kind, threads change nothing, and what is not claimed is seen to
// fail.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "reports/model/errors.hpp"
#include "reports/writers/json.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "support/verdicts.hpp"
#include "systems/bind.hpp"
#include "systems/rigid_body/rigid_body.hpp"

namespace polhode {
namespace {

using test::quick_results;

/// Under one noise vector no affordable degree resolves means to the bias of a splitting of weak order two.
bool stays_open(const report::results& r, const report::verdict& v) {
  return r.scene.name == "single" &&
         (v.claim == "leading constant of the stationary bias" || v.claim == "asymptotic variance converges" ||
          v.claim == "spectral gap converges");
}

/// Neither refuted nor open; every experiment says something of every scheme, and some claim holds.
void expect_no_failure(const report::results& r, const std::vector<std::string>& experiments) {
  int holding = 0;
  for (const auto& v : r.verdicts) {
    holding += v.kind == report::verdict_kind::holds;
    const bool open = v.kind == report::verdict_kind::inconclusive;
    EXPECT_TRUE(v.kind != report::verdict_kind::refuted && open == stays_open(r, v))
        << r.scene.name << ' ' << v.experiment << ' ' << v.scheme << ' ' << v.claim << ": " << v.reason;
  }
  EXPECT_GT(holding, 0) << r.scene.name;
  ASSERT_FALSE(r.schemes.empty());
  for (const auto& s : r.schemes)
    for (const auto& e : experiments)
      EXPECT_TRUE(
          std::ranges::any_of(r.verdicts, [&](const auto& v) { return v.scheme == s.name && v.experiment == e; }))
          << r.scene.name << ": " << e << " says nothing of " << s.name;
}

/// The nightly verification has every experiment; this one what costs seconds: not the timings, which the tests of the
/// paper's scene have, not the operators of high degree that one noise vector asks for, and not the bodies without
/// Gibbs law.
std::vector<std::string> tried_on(const std::string& scene) {
  std::set<std::string> dear{"work_precision"};
  if (scene == "single") dear.insert({"gibbs", "lyapunov", "weak"});
  if (scene == "anisotropic") dear.insert("attractor");
  std::vector<std::string> out;
  for (const auto& e : list_experiments())
    if (!dear.contains(e.name)) out.push_back(e.name);
  return out;
}

struct Scenes : testing::TestWithParam<const char*> {};

// Drifting, exact with areas, splitting; all schemes in the nightly verification.
TEST_P(Scenes, EveryClaimHoldsOrIsLeftOutWithAReason) {
  const auto tried = tried_on(GetParam());
  const auto r = quick_results(load_scene(GetParam()), tried, {"heun", "magnus", "strang"});
  EXPECT_EQ(r.schemes.size(), 3u);
  expect_no_failure(r, tried);
  for (const auto& s : r.skipped) EXPECT_FALSE(s.reason.empty());
}
INSTANTIATE_TEST_SUITE_P(BuiltIn, Scenes,
                         testing::Values("free", "dissipative", "undamped", "symmetric", "single", "anisotropic"));

// Also what is not claimed: an order found where none is claimed would be refuted, the intervals being two-sided.
TEST(Paper, StrongOrdersAreFoundWithinTheirIntervals) {
  const auto r = quick_results(load_scene("paper"), {"strong"});
  expect_no_failure(r, {"strong"});
  int orders = 0;
  for (const auto& v : r.verdicts)
    if (v.claim == "strong order") {
      ++orders;
      EXPECT_LE(*v.high - *v.low, 0.1) << v.scheme;
      EXPECT_NEAR(*v.estimate, *v.expected, 0.07) << v.scheme;
      EXPECT_EQ(*v.expected, v.scheme == "magnus" || v.scheme == "milstein" || v.scheme == "lie_milstein" ? 1.0 : 0.5)
          << v.scheme;
    }
  EXPECT_EQ(orders, static_cast<int>(list_schemes().size()));
}

TEST(Paper, ThreadsChangeNothing) {
  const auto text = [](int threads) {
    auto r =
        quick_results(load_scene("paper"), {"strong", "casimir", "gibbs"}, {"magnus", "heun", "strang_weak2"}, threads);
    r.provenance = {};
    return report::to_json(r);
  };
  EXPECT_EQ(text(1), text(3));
}

// Sampling stops for each scheme by itself, early where it may: neither its numbers nor its sample size know of others.
TEST(Paper, CompanyChangesNothing) {
  verify_options options{{"milstein"}, {"strong"}, effort::standard, 2, 1};
  const auto alone = verify(load_scene("paper"), options);
  options.schemes = {"milstein", "heun"};
  const auto both = verify(load_scene("paper"), options);
  const auto of_milstein = [](const report::results& r) {
    auto fits = r.fits;
    std::erase_if(fits, [](const auto& f) { return f.scheme != "milstein"; });
    return fits;
  };
  const auto first = of_milstein(alone), second = of_milstein(both);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].order, second[i].order) << first[i].quantity;
    EXPECT_EQ(first[i].rule, second[i].rule) << first[i].quantity;
  }
  int found = 0;
  for (const auto& f : both.fits) {
    if (f.quantity != "error") continue;
    ++found;
    EXPECT_NE(f.rule.find(" of 2048 planned paths were enough"), std::string::npos) << f.scheme << ": " << f.rule;
    EXPECT_LE(f.high - f.low, 0.04) << f.scheme;
  }
  EXPECT_EQ(found, 2);
}

TEST(Paper, AnotherSeedGivesOtherNumbersAndTheSameVerdicts) {
  auto options = verify_options{{"milstein"}, {"strong"}, effort::quick, 2, 1};
  const auto a = verify(load_scene("paper"), options);
  options.seed = 2;
  const auto b = verify(load_scene("paper"), options);
  EXPECT_NE(a.fits.at(0).order, b.fits.at(0).order);
  EXPECT_EQ(a.verdicts.at(0).kind, b.verdicts.at(0).kind);
}

// The laboratory is not fond of dimension three: another algebra, with two Casimirs and fifteen areas, goes through it.
TEST(So4, ClaimsHoldThere) {
  verify_options options;
  options.schemes = {"magnus", "lie_heun"};
  options.experiments = {"strong", "casimir"};
  options.effort = effort::quick;
  options.threads = 2;
  expect_no_failure(verify(load_scene("so4"), options), options.experiments);
}

// Orbits that are not compact, a product of spheres whose number a scene decides: paths and energy law are as claimed.
struct Systems : testing::TestWithParam<const char*> {};
TEST_P(Systems, ClaimsHoldThere) {
  verify_options options;
  options.schemes = {"magnus", "strang"};
  options.experiments = {"strong", "energy"};
  options.effort = effort::quick;
  options.threads = 2;
  expect_no_failure(verify(load_scene(GetParam()), options), options.experiments);
}
INSTANTIATE_TEST_SUITE_P(OffTheSphere, Systems, testing::Values("heavy_top", "spin_pair", "maxwell_bloch", "vortices"));

TEST(Growing, AfterEachExperimentButTheLastWhatIsThereIsTold) {
  verify_options options;
  options.experiments = {"casimir", "energy", "work_precision"};
  options.schemes = {"heun"};
  options.effort = effort::quick;
  std::vector<report::results> parts;
  options.so_far = [&](const report::results& r) { parts.push_back(r); };
  const auto whole = verify(load_scene("paper"), options);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].to_come, (std::vector<std::string>{"energy", "work_precision"}));
  EXPECT_EQ(parts[1].to_come, std::vector<std::string>{"work_precision"});
  EXPECT_TRUE(whole.to_come.empty());
  EXPECT_EQ(parts[1].experiments.size(), 2u);
  EXPECT_EQ(report::from_json(report::to_json(parts[1])).to_come, parts[1].to_come);
}

TEST(Options, UnknownNamesAreRefusedWithTheNearest) {
  const auto message = [](verify_options o) -> std::string {
    try {
      check_options(load_scene("paper"), o);
    } catch (const input_error& e) {
      return e.what();
    }
    return "";
  };
  verify_options scheme, experiment;
  scheme.schemes = {"milstien"};
  experiment.experiments = {"stong"};
  EXPECT_NE(message(scheme).find("did you mean 'milstein'"), std::string::npos);
  EXPECT_NE(message(experiment).find("did you mean 'strong'"), std::string::npos);
}

}  // namespace
}  // namespace polhode
