// Where schemes break: held to closed forms, and the same for any number of threads.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "experiments/common/levels.hpp"
#include "experiments/common/noise_verdict.hpp"
#include "experiments/stability/stability_limit.hpp"
#include "experiments/stability/stability_long.hpp"
#include "experiments/stability/stability_run.hpp"
#include "platform/work_counters.hpp"
#include "reports/writers/json.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"

namespace polhode {
namespace {

using names = std::vector<std::string>;

report::results quick(const scene& s, const names& schemes, int threads = 2) {
  verify_options options;
  options.schemes = schemes;
  options.experiments = {"stability"};
  options.effort = effort::quick;
  options.threads = threads;
  return verify(s, options);
}

const report::measurement& limit(const report::results& r, const std::string& scheme, const std::string& in) {
  for (const auto& m : r.measurements)
    if (m.scheme == scheme && m.quantity == "largest_stable_dt" && m.observable == in) return m;
  throw std::out_of_range(scheme + " " + in);
}

double row(const report::results& r, const std::string& quantity, const std::string& in) {
  for (const auto& m : r.measurements)
    if (m.scheme.empty() && m.quantity == quantity && m.observable == in) return *m.value;
  throw std::out_of_range(quantity + " " + in);
}

scene spherical(report::number_rows sigma) {
  auto s = load_scene("paper");
  s.vector("inertia") = {1, 1, 1};
  s.number("theta") = 0;
  s.vectors("sigma") = std::move(sigma);
  return s;
}

stability_limit find_limit(const step_range& range, const std::function<bool(std::int64_t)>& stable) {
  limit_search search(range);
  while (const auto steps = search.asks()) search.tell(stable(*steps));
  return search.limit();
}

TEST(StabilityLimit, IsFoundToFivePercentFromEitherSide) {
  for (const std::int64_t edge : {3, 40, 64, 65, 700, 100'000}) {
    const auto b = find_limit({2, 64, 1 << 20}, [&](std::int64_t n) { return n >= edge; });
    EXPECT_GE(b.stable, edge);
    EXPECT_LT(b.broken, edge);
    EXPECT_TRUE(b.stable == b.broken + 1 || 20 * b.stable <= 21 * b.broken) << edge;
  }
}

TEST(StabilityLimit, HasNoOtherSideWhereNothingOrAllBreaks) {
  const auto never = find_limit({2, 64, 512}, [](std::int64_t) { return true; });
  EXPECT_EQ(never.stable, 2);
  EXPECT_EQ(never.broken, 0);
  const auto always = find_limit({2, 64, 512}, [](std::int64_t) { return false; });
  EXPECT_EQ(always.stable, 0);
  EXPECT_EQ(always.broken, 512);
}

// A step of dt = 4 that is whole by accident, beyond steps that are not.
TEST(StabilityLimit, LongerStepsThatAreStableByAccidentDoNotCount) {
  const auto b = find_limit({2, 64, 512}, [](std::int64_t n) { return n >= 20 || n <= 4; });
  EXPECT_EQ(b.stable, 20);
}

// Nothing moves: c/I is the only rate, and no step of any size changes Pi.
TEST(Stability, BodyAtRestIsStableAtEveryStep) {
  const auto r = quick(spherical({}), {});
  std::size_t limits = 0;
  for (const auto& m : r.measurements)
    if (m.quantity == "largest_stable_dt" && m.observable == "scene") {
      ++limits;
      EXPECT_EQ(m.status, "stable at every dt tried") << m.scheme;
      EXPECT_NEAR(*m.value * row(r, "fastest_rate", "scene"), 32, 1e-12) << m.scheme;
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
  const auto r = quick(s, {"euler_maruyama"});
  const double across = 0.64, along = 0.36, w = 0.6 * 0.5;
  // h = across/2 + along/4 against its range [1/4, 1/2]; |Pi|^2 = across + along.
  const double by_energy = (2 * (0.5 + 0.1 * 0.5) - along / 2) / across, by_length = (1.21 - along) / across;
  // The mean of h is that of the one path: 5 % of 1/4.
  const double by_mean = (across / 2 + 0.05 * 0.25) / (across / 2);
  const double most = std::min({by_energy, by_length, by_mean});
  const double dt = first_dt(
      row(r, "horizon", "scene"), [&](double h) { return 1 + w * w * h * h; }, most);
  const auto& found = limit(r, "euler_maruyama", "scene");
  EXPECT_LE(*found.low, dt * (1 + 1e-9));
  EXPECT_GE(*found.high, dt * (1 - 1e-9));
  EXPECT_EQ(found.status, "first broken: mean energy");
}

// One noise vector s e3, spherical body: Euler-Maruyama multiplies the square of the part across e3 by
// (1 - s^2 dt/2)^2 + s^2 dW^2, whatever its direction. So the share of broken paths is that of a product of known
// random factors, sampled here with numbers of the standard library.
TEST(Stability, OneVectorOnASphericalBodyBreaksAsTheProductOfItsFactors) {
  const auto s = bind_scene(spherical({{0, 0, 0.7}}));
  auto plain = s.scene;
  plain.momentum = {1, 0, 0};
  stability_case c{.name = "one vector", .bound = s.with(plain), .rate = 1, .horizon = 8, .radius = 1};
  c.least_energy = c.greatest_energy = 0.5;
  const auto& scheme = c.bound.schemes.front();
  ASSERT_EQ(scheme.info.name, "euler_maruyama");
  std::mt19937_64 bits(7);
  std::normal_distribution<double> normal;
  for (const int steps : {40, 160, 640}) {
    const double dt = c.horizon / steps, v = 0.49 * dt;
    const int paths = 20'000;
    int broken = 0;
    for (int path = 0; path < paths; ++path) {
      double square = 1;
      bool whole = true;
      for (int i = 0; i < steps; ++i) {
        square *= std::pow(1 - v / 2, 2) + v * std::pow(normal(bits), 2);
        // As often as the run looks; h leaves its range at |Pi|^2 = 1.1 or 0.9.
        if ((i + 1) % std::clamp(steps / 64, 1, 16) == 0 || i + 1 == steps)
          whole = whole && square <= 1.1 && square >= 0.9;
      }
      broken += !whole;
    }
    const auto found = run_until_broken(c, scheme, {dt, steps, 20'032, 1, noise_generator::philox, true});
    const double share = static_cast<double>(found.broken) / found.paths,
                 expected = static_cast<double>(broken) / paths;
    EXPECT_EQ(found.paths, 20'032);
    EXPECT_NEAR(share, expected, 4 * std::sqrt(2 * expected * (1 - expected) / paths) + 1e-3) << steps;
  }
}

// Schemes with areas and without, implicit or not, of different dt: what they share is drawn for no dt at all.
TEST(Stability, RunsTogetherAreWhatEachIsAlone) {
  const auto s = bind_scene(load_scene("paper"));
  stability_case c{.name = "paper", .bound = s, .rate = 1, .horizon = 8, .radius = 1};
  c.least_energy = 1.0 / 6;
  c.greatest_energy = 0.5;
  std::vector<stability_member> members;
  for (std::size_t k = 0; k < s.schemes.size(); ++k) members.push_back({&c, &s.schemes[k], 0.1 + 0.002 * double(k)});
  c.mean_energy = run_until_broken(c, s.schemes.back(), {0.1, 80, 4096, 2}).mean_energy;
  for (const bool to_the_end : {false, true}) {
    const auto together = run_until_broken(members, {0, 80, 256, 1, noise_generator::philox, to_the_end});
    int broken = 0;
    for (std::size_t k = 0; k < members.size(); ++k) {
      const auto alone =
          run_until_broken(c, s.schemes[k], {members[k].dt, 80, 256, 1, noise_generator::philox, to_the_end});
      broken += !alone.stable();
      EXPECT_EQ(together[k].paths, alone.paths) << s.schemes[k].info.name;
      EXPECT_EQ(together[k].broken, alone.broken) << s.schemes[k].info.name;
      EXPECT_EQ(together[k].first, alone.first) << s.schemes[k].info.name;
      EXPECT_EQ(together[k].mean_energy, alone.mean_energy) << s.schemes[k].info.name;
      EXPECT_EQ(together[k].worst_casimir, alone.worst_casimir) << s.schemes[k].info.name;
    }
    EXPECT_GT(broken, 0);
    EXPECT_LT(broken, static_cast<int>(members.size()));
  }
}

TEST(Stability, ThreadsAndCompanyChangeNothing) {
  const auto text = [](const names& schemes, int threads) {
    auto r = quick(load_scene("single"), schemes, threads);
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

// A random walk of rounding, not a drift: slower than the number of steps, and far below 1e-12 after a million.
TEST(Stability, LongDriftIsRoundingAlone) {
  const auto s = bind_scene(load_scene("paper"));
  int tried = 0;
  for (const auto& scheme : s.schemes) {
    if (!scheme.info.casimir.exact) continue;
    ++tried;
    const auto d = drift_over(s, scheme, 0.03125, 1 << 19, 1, noise_generator::philox);
    ASSERT_EQ(d.steps, (std::vector<double>{1 << 16, 1 << 17, 1 << 18, 1 << 19})) << scheme.info.name;
    EXPECT_LT(d.rms.back(), 1e-12) << scheme.info.name;
    EXPECT_GT(d.rms.back(), 0) << scheme.info.name;
  }
  EXPECT_GT(tried, 0);
}

TEST(Stability, RareBreaksAreCountedAmongTheirPaths) {
  const auto s = bind_scene(spherical({{0, 0, 0.7}}));
  stability_case c{.name = "one vector", .bound = s, .rate = 1, .horizon = 8, .radius = 1};
  c.least_energy = c.greatest_energy = 0.5;
  report::results out;
  const context at{s, effort::thorough, 1, 1, noise_generator::philox, [](double) {}};
  recorder record("stability", s.schemes.front().info.name, out);
  report_rare_breaks(at, c, s.schemes.front(), {256, 128}, record);
  ASSERT_EQ(out.measurements.size(), 1u);
  const auto& m = out.measurements.front();
  EXPECT_EQ(*m.dt(), 8.0 / 512);
  EXPECT_LE(*m.low, *m.value);
  EXPECT_GE(*m.high, *m.value);
  EXPECT_LT(*m.high - *m.low, 4e-3);
}

// Figures of the house by counters, not by time: 14 schemes at quick effort.
TEST(Stability, CostsWhatItMay) {
  const auto before = work_so_far();
  quick(load_scene("paper"), {});
  const auto after = work_so_far();
  EXPECT_GT(after.path_steps, before.path_steps);
  EXPECT_GT(after.normals, before.normals);
  EXPECT_LT(after.path_steps - before.path_steps, 3'000'000'000u);
  EXPECT_LT(after.normals - before.normals, 4'500'000'000u);  // each run alone: 11e9
}

/// One verdict, and the largest deviation of each part.
void expect_the_noise_of(const report::results& r, const names& parts) {
  int verdicts = 0;
  for (const auto& v : r.verdicts)
    if (v.scheme == noise_name) {
      ++verdicts;
      EXPECT_EQ(v.kind, report::verdict_kind::holds) << v.reason;
    }
  EXPECT_EQ(verdicts, 1);
  names heard;
  for (const auto& m : r.measurements)
    if (m.scheme == noise_name) heard.push_back(m.observable.substr(0, m.observable.find(':')));
  EXPECT_EQ(heard, parts);
}

TEST(Stability, SchemesThatKeepTheOrbitNeverBreakByIt) {
  const auto r = quick(load_scene("paper"), {"heun", "lie_heun", "implicit_midpoint"});
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
  expect_the_noise_of(r, {"reference", "border", "map"});
}

}  // namespace
}  // namespace polhode
