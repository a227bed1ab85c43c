// SPDX-License-Identifier: Apache-2.0
// Where schemes break: held to closed forms, and the same for any number of threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "platform/work_counters.hpp"
#include "reports/writers/json.hpp"
#include "run/run_experiment.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "support/verdicts.hpp"
#include "verification/stability_bodies.hpp"

namespace polhode {
namespace {

using test::spherical;
using names = std::vector<std::string>;

report::results stability_of(const scene& s, const names& schemes, int threads = 2) {
  return test::quick_results(s, {"stability"}, schemes, threads);
}

const report::measurement& limit(const report::results& r, const std::string& scheme, const std::string& in) {
  for (const auto& m : r.measurements)
    if (m.scheme == scheme && m.quantity == "largest_stable_dt" && m.observable == in) return m;
  throw std::out_of_range(scheme + " " + in);
}

double value_in(const report::results& r, const std::string& quantity, const std::string& in) {
  for (const auto& m : r.measurements)
    if (m.scheme.empty() && m.quantity == quantity && m.observable == in) return *m.value;
  throw std::out_of_range(quantity + " " + in);
}

// Nothing moves: c/I is the only rate, and no step of any size changes Pi.
TEST(Stability, BodyAtRestIsStableAtEveryStep) {
  const auto r = stability_of(spherical({}), {});
  std::size_t limits = 0;
  for (const auto& m : r.measurements)
    if (m.quantity == "largest_stable_dt" && m.observable == "scene") {
      ++limits;
      EXPECT_EQ(m.status, "stable at every dt tried") << m.scheme;
      EXPECT_NEAR(*m.value * value_in(r, "fastest_rate", "scene"), 32, 1e-12) << m.scheme;
    }
  EXPECT_EQ(limits, list_schemes().size());
}

/// The limit of |Pi| = c (1 + x)^(n/2) >= 1.05^(1/2) or 1.1 c: dt with n dt = T.
double first_dt(double horizon, const std::function<double(double dt)>& growth_per_step, double most) {
  std::int64_t n = 1;
  while (std::pow(growth_per_step(horizon / static_cast<double>(n)), static_cast<double>(n)) > most) ++n;
  return horizon / static_cast<double>(n);
}

// Free symmetric top, explicit Euler: the part of Pi across the odd axis turns at the constant rate w = Pi_3 (1/I_1 -
// 1/I_3) and grows by (1 + w^2 dt^2)^(1/2) a step, Pi_3 stays. h leaves its range by 10 % where |Pi|^2 has grown so.
TEST(Stability, ExplicitEulerBreaksWhereItsClosedFormDoes) {
  auto s = load_scene("free");
  s.vector("inertia") = {1, 1, 2};
  s.momentum = {0.8, 0, 0.6};
  const auto r = stability_of(s, {"euler_maruyama"});
  const double across = 0.64, along = 0.36, w = 0.6 * 0.5;
  // h = across/2 + along/4 against its range [1/4, 1/2]; |Pi|^2 = across + along.
  const double by_energy = (2 * (0.5 + 0.1 * 0.5) - along / 2) / across, by_length = (1.21 - along) / across;
  // The mean of h is that of the one path: 5 % of 1/4.
  const double by_mean = (across / 2 + 0.05 * 0.25) / (across / 2);
  const double most = std::min({by_energy, by_length, by_mean});
  const double dt = first_dt(
      value_in(r, "horizon", "scene"), [&](double h) { return 1 + w * w * h * h; }, most);
  const auto& found = limit(r, "euler_maruyama", "scene");
  EXPECT_LE(*found.low, dt * (1 + 1e-9));
  EXPECT_GE(*found.high, dt * (1 - 1e-9));
  EXPECT_EQ(found.status, "first broken: mean energy");
}

/// Two bodies without a bond; the second, of equal moments of inertia, is at rest in its axes.
scene unbound_tops() {
  auto s = load_scene("so4");
  s.vector("inertia") = {1, 1, 2, 1, 1, 1};
  s.number("coupling") = 0;
  s.number("theta") = 0;
  s.vectors("sigma") = {};
  s.momentum = {0.8, 0, 0.6, 0, 0.6, 0.8};
  return s;
}

// The same top as one of two bodies, on a product of spheres: nothing is known there of the range of h, and nothing
// moves h. |Pi| of the first is its Casimir.
TEST(Stability, ElsewhereThanOnASphereExplicitEulerBreaksByItsCasimir) {
  const auto r = stability_of(unbound_tops(), {"euler_maruyama", "lie_euler"});
  const double w = 0.6 * 0.5;
  const double dt = first_dt(
      value_in(r, "horizon", "scene"), [&](double h) { return 1 + w * w * h * h; }, (1.21 - 0.36) / 0.64);
  const auto& found = limit(r, "euler_maruyama", "scene");
  EXPECT_LE(*found.low, dt * (1 + 1e-9));
  EXPECT_GE(*found.high, dt * (1 - 1e-9));
  EXPECT_EQ(found.status, "first broken: Casimir");
  EXPECT_EQ(limit(r, "lie_euler", "scene").status,
            "stable at every dt tried");  // turns about an axis at a constant rate
}

TEST(Stability, IsFoundOnEverySystem) {
  for (const char* name :
       {"heavy_top", "maxwell_bloch", "manakov", "sine_euler", "spin_pair", "spin_ring", "vortices"}) {
    const auto r = stability_of(load_scene(name), {"lie_heun"});
    const auto& found = limit(r, "lie_heun", "scene");
    ASSERT_TRUE(found.low && found.high) << name;
    const double rate = value_in(r, "fastest_rate", "scene");
    EXPECT_GT(*found.low * rate, 0.125) << name;  // where the search begins
    EXPECT_LT(*found.high * rate, 32) << name;
    EXPECT_EQ(found.status, "first broken: mean energy") << name;
    for (const auto& v : r.verdicts) EXPECT_EQ(v.kind, report::verdict_kind::holds) << name << ": " << v.reason;
  }
}

TEST(Stability, AFalseClaimToKeepTheOrbitIsRefutedElsewhereToo) {
  auto s = bind_scene(load_scene("so4"));
  std::erase_if(s.schemes, [](const scheme_entry& e) { return e.info.name != "heun" && e.info.name != "lie_heun"; });
  for (auto& e : s.schemes) e.info.casimir.exact = true;
  s.with = [schemes = s.schemes, with = s.with](const report::scene& other) {
    auto out = restricted(with(other), {"heun", "lie_heun"});
    for (auto& e : out.schemes) e.info.casimir.exact = true;
    return out;
  };
  verify_options options;
  options.experiments = {"stability"};
  options.effort = effort::quick;
  options.threads = 2;
  const auto r = verify_subject(s, options);
  int judged = 0;
  for (const auto& v : r.verdicts)
    if (v.claim == "on its orbit up to half the largest stable dt") {
      ++judged;
      EXPECT_EQ(v.kind, v.scheme == "heun" ? report::verdict_kind::refuted : report::verdict_kind::holds) << v.reason;
    }
  EXPECT_EQ(judged, 2);
  EXPECT_EQ(limit(r, "lie_heun", "scene").status, "first broken: mean energy");
  test::expect_noise_of(r, {"reference", "border", "map"});
}

TEST(Stability, ThreadsAndCompanyChangeNothing) {
  const auto text = [](const names& schemes, int threads) {
    auto r = stability_of(load_scene("single"), schemes, threads);
    r.provenance = {};
    r.done = {};
    if (schemes.size() > 1) {
      std::erase_if(r.measurements, [](const auto& m) { return m.scheme == "milstein"; });
      std::erase_if(r.verdicts, [](const auto& v) { return v.scheme == "milstein"; });
      std::erase_if(r.fits, [](const auto& f) { return f.scheme == "milstein"; });
      std::erase_if(r.schemes, [](const auto& v) { return v.name == "milstein"; });
    }
    return report::to_json(r);
  };
  const auto alone = text({"lie_heun"}, 1);
  EXPECT_EQ(alone, text({"lie_heun"}, 3));
  EXPECT_EQ(alone, text({"lie_heun", "milstein"}, 2));
}

// Figures of the house by counters, not by time: 14 schemes at quick effort.
TEST(Stability, CostsWhatItMay) {
  const auto before = work_so_far();
  stability_of(load_scene("paper"), {});
  const auto after = work_so_far();
  EXPECT_GT(after.path_steps, before.path_steps);
  EXPECT_GT(after.normals, before.normals);
  EXPECT_LT(after.path_steps - before.path_steps, 3'000'000'000u);
  EXPECT_LT(after.normals - before.normals, 4'500'000'000u);  // each run alone: 11e9
}

TEST(Stability, SchemesThatKeepTheOrbitNeverBreakByIt) {
  const auto r = stability_of(load_scene("paper"), {"heun", "lie_heun", "implicit_midpoint"});
  int judged = 0;
  for (const auto& v : r.verdicts)
    if (v.claim.find("at every dt") != std::string::npos) {
      ++judged;
      EXPECT_NE(v.scheme, "heun");  // claims nothing
      EXPECT_EQ(v.kind, report::verdict_kind::holds) << v.scheme << ": " << v.reason;
    }
  EXPECT_EQ(judged, 4);
  EXPECT_EQ(limit(r, "implicit_midpoint", "scene").status, "first broken: step not solved");
  EXPECT_EQ(limit(r, "lie_heun", "scene").status, "first broken: mean energy");
  EXPECT_LT(*limit(r, "heun", "scene").value, 0.1 * *limit(r, "lie_heun", "scene").value);
  EXPECT_FALSE(limit(r, "lie_heun", "denormal c").value);
  test::expect_noise_of(r, {"reference", "border", "map"});
}

}  // namespace
}  // namespace polhode
