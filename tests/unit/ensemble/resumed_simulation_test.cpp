// SPDX-License-Identifier: Apache-2.0
// A run that is interrupted and taken up again, and one that is shared by ranks, against the run in one piece.
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "ensemble/simulation.hpp"
#include "run/verify.hpp"

namespace polhode {
namespace {

using bytes = std::vector<char>;

bytes bytes_of(const ensemble_progress& at) {
  bytes out;
  at.write([&](const void* from, std::size_t count) {
    out.insert(out.end(), static_cast<const char*>(from), static_cast<const char*>(from) + count);
  });
  return out;
}

void read_into(ensemble_progress& at, const bytes& all) {
  std::size_t next = 0;
  at.read([&](void* to, std::size_t count) {
    if (next + count > all.size()) throw std::runtime_error("cut short");
    std::copy_n(all.data() + next, count, static_cast<char*>(to));  // count may be 0, to null
    next += count;
  });
  EXPECT_EQ(next, all.size());
}

struct ensemble {
  subject s;
  const scheme_entry& scheme;
  simulation_plan plan;

  ensemble(const char* scene, std::string_view name, ensemble_noise noise, int threads)
      : s(bind_scene(load_scene(scene))),
        scheme(*std::ranges::find_if(s.schemes, [&](const auto& e) { return e.info.name == name; })) {
    plan.noise = noise;
    plan.start = s.sphere() ? ensemble_start::uniform : ensemble_start::orbit;
    plan.momentum = s.scene.momentum;
    plan.steps = 1100;
    plan.slice = 1000;
    plan.bodies = 150;  // three blocks, the last one short
    if (s.sphere()) plan.snapshots = {7, 1050, 1100};
    plan.seed = 5;
    plan.threads = threads;
    plan.with_areas = scheme.needs_areas;
  }
  simulated run() const { return simulate_ensemble(*s.model, *scheme.make(1e-3), plan); }
};

void expect_same(const running_moments& a, const running_moments& b) {
  EXPECT_EQ(a.count, b.count);
  EXPECT_EQ(a.mean, b.mean);
  EXPECT_EQ(a.squares, b.squares);
}

void expect_same(const ensemble_moments& a, const ensemble_moments& b) {
  expect_same(a.energy, b.energy);
  for (std::size_t k = 0; k < a.components.size(); ++k) expect_same(a.components[k], b.components[k]);
  EXPECT_EQ(a.lost, b.lost);
  EXPECT_EQ(a.casimir_change, b.casimir_change);
}

void expect_same(const simulated& a, const simulated& b) {
  EXPECT_EQ(a.states, b.states);
  expect_same(a.final, b.final);
  ASSERT_EQ(a.snapshots.size(), b.snapshots.size());
  for (std::size_t i = 0; i < a.snapshots.size(); ++i) {
    expect_same(a.snapshots[i].moments, b.snapshots[i].moments);
    EXPECT_EQ(a.snapshots[i].counts, b.snapshots[i].counts);
    EXPECT_EQ(a.snapshots[i].picture, b.snapshots[i].picture);
  }
  EXPECT_EQ(a.drawn, b.drawn);
}

struct killed {};

/// Killed after every save; how often.
int run_in_pieces(ensemble e, simulated& out) {
  bytes saved;
  e.plan.save_due = [] { return true; };
  e.plan.save = [&](const ensemble_progress& at) {
    saved = bytes_of(at);
    throw killed{};
  };
  e.plan.resume = [&](ensemble_progress& at) {
    if (!saved.empty()) read_into(at, saved);
  };
  for (int kills = 0;;) try {
      out = e.run();
      return kills;
    } catch (const killed&) {
      ++kills;
    }
}

TEST(ResumedSimulation, IsTheUninterruptedOneBitForBit) {
  for (const auto noise : {ensemble_noise::common, ensemble_noise::independent, ensemble_noise::none})
    for (const auto* scheme : {"strang", "magnus"})
      for (const int threads : {1, 3}) {
        const ensemble e("paper", scheme, noise, threads);
        simulated resumed;
        EXPECT_GE(run_in_pieces(e, resumed), 12 / threads) << "stops: three snapshots and a slice, of three blocks";
        expect_same(resumed, e.run());
      }
}

TEST(ResumedSimulation, OnAnOrbitWithoutStates) {
  ensemble e("heavy_top", "lie_heun", ensemble_noise::independent, 2);
  e.plan.keep_states = false;
  simulated resumed;
  EXPECT_GE(run_in_pieces(e, resumed), 3) << "two stops of three blocks, by two threads";
  const auto whole = e.run();
  EXPECT_TRUE(whole.states.empty());
  expect_same(resumed, whole);
}

TEST(ResumedSimulation, WhatIsOfAnotherEnsembleIsRefused) {
  const ensemble mine("paper", "strang", ensemble_noise::independent, 1);
  for (auto other : {ensemble("paper", "strang", ensemble_noise::independent, 1),
                     ensemble("spin_pair", "strang", ensemble_noise::independent, 1)}) {
    bytes saved;
    other.plan.bodies = 100;
    other.plan.save_due = [&] { return saved.empty(); };
    other.plan.save = [&](const ensemble_progress& at) { saved = bytes_of(at); };
    other.run();
    auto plan = mine.plan;
    plan.resume = [&](ensemble_progress& at) { read_into(at, saved); };
    EXPECT_THROW(simulate_ensemble(*mine.s.model, *mine.scheme.make(1e-3), plan), std::runtime_error);
  }
}

TEST(SharedSimulation, RanksTogetherAreTheWholeBitForBit) {
  const ensemble whole("paper", "milstein", ensemble_noise::independent, 1);
  for (const int ranks : {2, 3, 5}) {  // five: two have nothing to do
    std::vector<bytes> done;
    simulated out;
    for (int rank = ranks - 1; rank >= 0; --rank) {
      auto plan = whole.plan;
      plan.rank = rank;
      plan.ranks = ranks;
      plan.join = [&](ensemble_progress& at) {
        if (rank > 0) return done.push_back(bytes_of(at));
        for (const auto& theirs : done) {
          auto other = at;
          read_into(other, theirs);
          at.join(other);
        }
      };
      out = simulate_ensemble(*whole.s.model, *whole.scheme.make(1e-3), plan);
    }
    expect_same(out, whole.run());
  }
}

}  // namespace
}  // namespace polhode
