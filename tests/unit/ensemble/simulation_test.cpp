// SPDX-License-Identifier: Apache-2.0
#include "ensemble/simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include <polhode/integrate.hpp>

#include "ensemble/noise/paths.hpp"
#include "ensemble/noise/shared_increments.hpp"
#include "ensemble/observing/sphere_bins.hpp"
#include "run/verify.hpp"
#include "support/schemes.hpp"

namespace polhode {
namespace {

constexpr double step_size = 0.02;

simulation_plan plan_of(ensemble_noise noise, ensemble_start start) {
  simulation_plan p;
  p.noise = noise;
  p.start = start;
  p.momentum = {0.6, 0.48, 0.64};
  p.steps = 150;  // no multiple of the chunk
  p.bodies = 37;  // nor of the block
  p.snapshots = {7, 150};
  p.seed = 5;
  p.threads = 2;
  return p;
}

const scheme_entry& scheme_named(const subject& s, std::string_view name) {
  return *std::ranges::find_if(s.schemes, [&](const auto& e) { return e.info.name == name; });
}

simulated run(const subject& s, std::string_view scheme, simulation_plan p) {
  const auto& entry = scheme_named(s, scheme);
  p.with_areas = entry.needs_areas;
  return simulate_ensemble(*s.model, *entry.make(step_size), p);
}

vec<double, 3> start_of(const simulation_plan& p, std::uint64_t body) {
  if (p.start == ensemble_start::momentum) return test::paper_momentum;
  const auto x = normals<3>({p.seed, noise_kind::initial_state, body, 0});
  return std::sqrt(dot(test::paper_momentum, test::paper_momentum) / dot(x, x)) * x;
}

TEST(Simulation, EveryBodyIsTheLoopOfTheLibrary) {
  const auto s = bind_scene(load_scene("paper"));
  for (const auto noise : {ensemble_noise::common, ensemble_noise::independent, ensemble_noise::none})
    for (const auto start : {ensemble_start::uniform, ensemble_start::momentum}) {
      const auto p = plan_of(noise, start);
      const auto all = run(s, "strang", p);
      const auto body_system = test::paper_body(0.5, noise == ensemble_noise::none ? 0.0 : 0.5);
      for (std::size_t body = 0; body < 37; ++body) {
        const auto path = noise == ensemble_noise::common ? 0 : static_cast<std::uint64_t>(body);
        const auto alone = integrate<strang>(body_system, start_of(p, body), step_size, 150, {.seed = 5, .path = path});
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(all.states[k * 37 + body], alone[static_cast<int>(k)], 1e-13);
      }
    }
}

TEST(Simulation, CommonNoiseIsOneNoise) {
  const auto s = bind_scene(load_scene("paper"));
  for (const auto* scheme : {"strang", "milstein", "magnus"}) {
    const auto alike = run(s, scheme, plan_of(ensemble_noise::common, ensemble_start::momentum));
    const auto apart = run(s, scheme, plan_of(ensemble_noise::independent, ensemble_start::momentum));
    for (std::size_t body = 1; body < 37; ++body) {
      EXPECT_EQ(alike.states[body], alike.states[0]) << scheme;
      EXPECT_NE(apart.states[body], apart.states[0]) << scheme;
    }
    EXPECT_NEAR(alike.states[0], apart.states[0], 1e-13) << "body 0 has the noise of path 0 either way";
  }
}

TEST(Simulation, SharedIncrementsAreThoseOfPathZero) {
  for (const auto* name : {"paper", "single"}) {
    const auto s = bind_scene(load_scene(name));
    const shared_increments shared(*s.model, 3, 100, 0.25, true, 2);
    increment_buffer own(*s.model, 10, true);
    const auto here = shared.view(40, 10), there = own.fill(3, 0, 40, 10, 0.25);
    ASSERT_EQ(here.dw.size(), 3u * 10u) << name;
    ASSERT_EQ(here.area.size(), 3u * 10u) << name;
    for (std::size_t i = 0; i < here.dw.size(); ++i) EXPECT_NEAR(here.dw[i], there.dw[i * block_lanes], 1e-15);
    for (std::size_t i = 0; i < here.area.size(); ++i) EXPECT_NEAR(here.area[i], there.area[i * block_lanes], 1e-15);
  }
}

/// The increments of a common noise and the kernel's table of it are held at once.
TEST(Simulation, TheMemoryOfACommonNoiseIsReckonedAsItIsHeld) {
  for (const auto* name : {"paper", "heavy_top", "so4", "spin_ring", "sine_euler"}) {
    const auto s = bind_scene(load_scene(name));
    for (const auto& scheme : s.schemes) {
      const auto stepper = scheme.make(step_size);
      auto p = plan_of(ensemble_noise::common, ensemble_start::momentum);
      p.with_areas = scheme.needs_areas;
      const shared_increments drawn(*s.model, p.seed, p.steps, step_size, p.with_areas, 1);
      const auto view = drawn.view(0, static_cast<int>(p.steps));
      const auto numbers = view.dw.size() + view.area.size() + stepper->share(view).table.size();
      const double reckoned = simulation_bytes(*s.model, *stepper, p);
      p.noise = ensemble_noise::none;
      EXPECT_EQ(reckoned - simulation_bytes(*s.model, *stepper, p), static_cast<double>(numbers * sizeof(double)))
          << name << ", " << scheme.info.name;
    }
  }
}

TEST(Simulation, SnapshotsCountEveryBodyOnce) {
  const auto s = bind_scene(load_scene("paper"));
  const auto out = run(s, "strang", plan_of(ensemble_noise::common, ensemble_start::uniform));
  ASSERT_EQ(out.snapshots.size(), 2u);
  for (const auto& shot : out.snapshots) {
    EXPECT_EQ(std::accumulate(shot.counts.begin(), shot.counts.end(), 0u), 37u);
    EXPECT_EQ(std::accumulate(shot.picture.begin(), shot.picture.end(), 0u), 37u);
    EXPECT_EQ(shot.moments.energy.count, 37);
    EXPECT_LT(shot.moments.casimir_change, 1e-13);
  }
  EXPECT_EQ(out.snapshots[1].moments.energy.mean, out.final.energy.mean) << "the last snapshot is at the end";
  EXPECT_EQ(out.drawn, 3u * 150u);
}

TEST(Simulation, TheLoopDoesNotSeeItsStops) {
  const auto s = bind_scene(load_scene("paper"));
  auto p = plan_of(ensemble_noise::independent, ensemble_start::uniform);
  const auto with = run(s, "lie_heun", p);
  p.snapshots.clear();
  p.threads = 1;
  EXPECT_EQ(run(s, "lie_heun", p).states, with.states);
}

// As many uniform directions in one bin as in another: the poles and the seam are no exceptions.
TEST(SphereBins, HaveEqualAreas) {
  std::vector<double> thirds(3 * 4);
  double disc = 0;
  constexpr std::uint64_t n = 200'000;
  for (std::uint64_t i = 0; i < n; ++i) {
    const auto x = normals<3>({1, noise_kind::initial_state, i, 0});
    const auto u = (1 / std::sqrt(dot(x, x))) * x;
    const auto bin = static_cast<std::size_t>(longitude_bins::of(u[0], u[1], u[2]));
    ASSERT_LT(bin, longitude_bins::count);
    ++thirds[bin / longitude_bins::longitudes / 171 * 4 + bin % longitude_bins::longitudes / 256];
    const auto cell = static_cast<std::size_t>(hemisphere_bins::of(u[0], u[1], u[2])) % (512 * 512);
    const auto row = cell / 512, column = cell % 512;
    disc += std::hypot(static_cast<double>(row) - 255.5, static_cast<double>(column) - 255.5) < 128;
  }
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      EXPECT_NEAR(thirds[static_cast<std::size_t>(row * 4 + column)] / n, (row < 2 ? 171. : 170.) / 2048, 0.004);
  EXPECT_NEAR(disc / n, 0.25, 0.005) << "half the radius holds a quarter of the area";
}

}  // namespace
}  // namespace polhode
