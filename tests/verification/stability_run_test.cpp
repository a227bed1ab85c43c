// SPDX-License-Identifier: Apache-2.0
// Runs until something breaks: against a product of known factors, alone and together, long ones and rare breaks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "experiments/common/levels.hpp"
#include "experiments/stability/stability_limit.hpp"
#include "experiments/stability/stability_long.hpp"
#include "experiments/stability/stability_run.hpp"
#include "run/verify.hpp"
#include "verification/stability_bodies.hpp"

namespace polhode {
namespace {

using test::spherical;

// One noise vector s e3, spherical body: Euler-Maruyama multiplies the square of the part across e3 by
// (1 - s^2 dt/2)^2 + s^2 dW^2, whatever its direction. So the share of broken paths is that of a product of known
// random factors, sampled here with numbers of the standard library.
TEST(Stability, OneVectorOnASphericalBodyBreaksAsTheProductOfItsFactors) {
  const auto s = bind_scene(spherical({{0, 0, 0.7}}));
  auto plain = s.scene;
  plain.momentum = {1, 0, 0};
  stability_case c{
      .name = "one vector", .bound = s.with(plain), .rate = 1, .horizon = 8, .casimirs = {1}, .casimir_sizes = {1}};
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
  stability_case c{.name = "paper", .bound = s, .rate = 1, .horizon = 8, .casimirs = {1}, .casimir_sizes = {1}};
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
  stability_case c{.name = "one vector", .bound = s, .rate = 1, .horizon = 8, .casimirs = {1}, .casimir_sizes = {1}};
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

}  // namespace
}  // namespace polhode
