// SPDX-License-Identifier: Apache-2.0
// Strong orders in other norms and path by path, on the schemes themselves: what is claimed holds, what is claimed too
// much is refuted by each, and the distance of the reference is that of a closed form.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "experiments/common/levels.hpp"
#include "experiments/strong/path_orders.hpp"
#include "run/run_experiment.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "support/kernel_decorator.hpp"
#include "systems/bind.hpp"
#include "systems/rigid_body/rigid_body.hpp"

namespace polhode {
namespace {

using report::verdict_kind;

constexpr std::array claims{"strong order in the supremum over time", "strong order in L^1", "strong order in L^4",
                            "strong order of almost every path"};

const report::verdict& verdict_of_scheme(const report::results& r, const std::string& scheme, const std::string& text) {
  for (const auto& v : r.verdicts)
    if (v.scheme == scheme && v.claim == text) return v;
  throw std::out_of_range(text);
}

report::results quick_on(const subject& s, int threads = 2) {
  return verify_subject(s, {{}, {"strong"}, effort::quick, threads, 1});
}

subject paper(const std::vector<std::string>& schemes) { return restricted(bind_scene(load_scene("paper")), schemes); }

TEST(PathOrders, HoldInEveryNorm) {
  const auto r = quick_on(paper({"heun", "magnus"}));
  for (const auto* scheme : {"heun", "magnus"})
    for (const auto* text : claims)
      EXPECT_EQ(verdict_of_scheme(r, scheme, text).kind, verdict_kind::holds) << scheme << ", " << text;
}

TEST(PathOrders, ClaimedTooHighAreRefutedByEveryNorm) {
  auto s = paper({"lie_heun"});
  s.schemes.front().info.strong_order = {1.5, 1};
  const auto r = quick_on(s);
  for (const auto* text : claims)
    EXPECT_EQ(verdict_of_scheme(r, "lie_heun", text).kind, verdict_kind::refuted)
        << verdict_of_scheme(r, "lie_heun", text).reason;
}

/// Turns the state by dt^(1/4) / 10 about the third axis after one of its calls, and back before the next: right at the
/// end, and of order 1/4 on the way. One thread calls it, block after block.
class wrong_on_the_way final : public test::kernel_decorator {
 public:
  using kernel_decorator::advance;
  wrong_on_the_way(std::unique_ptr<kernel> right, int calls) : kernel_decorator(std::move(right)), calls_(calls) {}
  void advance(std::span<double> states, const increment_view& v, piece p) const override {
    const double angle = std::pow(dt(), 0.25) / 10;
    if (call_ == wrong()) turn(states, -angle);
    kernel_decorator::advance(states, v, p);
    call_ = (call_ + 1) % calls_;
    if (call_ == wrong()) turn(states, angle);
  }

 private:
  /// After this one: an odd one, whose end is none of a coarser level's; never the last.
  int wrong() const { return calls_ / 4 * 2 + 1; }
  static void turn(std::span<double> states, double angle) {
    for (std::size_t lane = 0; lane < block_lanes; ++lane) {
      const double x = states[lane], y = states[block_lanes + lane];
      states[lane] = std::cos(angle) * x - std::sin(angle) * y;
      states[block_lanes + lane] = std::sin(angle) * x + std::cos(angle) * y;
    }
  }
  int calls_;
  mutable int call_ = 0;
};

TEST(PathOrders, WhatIsWrongOnTheWayAloneIsSeenInTheSupremumAlone) {
  auto s = paper({"lie_heun"});
  const auto grid = asymptotic_levels(s, 256);
  auto& entry = s.schemes.front();
  entry.make = [healthy = entry.make, grid](double dt) -> std::unique_ptr<kernel> {
    const int steps = static_cast<int>(std::lround(grid.horizon / dt));
    return std::make_unique<wrong_on_the_way>(healthy(dt), std::min(steps, grid.steps[grid.steps.size() - 2]));
  };
  const auto r = quick_on(s, 1);
  EXPECT_EQ(verdict_of_scheme(r, "lie_heun", "strong order").kind, verdict_kind::holds);
  EXPECT_EQ(verdict_of_scheme(r, "lie_heun", "strong order in L^4").kind, verdict_kind::holds);
  EXPECT_EQ(verdict_of_scheme(r, "lie_heun", "strong order in the supremum over time").kind, verdict_kind::refuted);
  EXPECT_EQ(verdict_of_scheme(r, "lie_heun", "strong order of almost every path").kind, verdict_kind::refuted);
}

// A tenth of a time scale: levels of 1 to 32 steps. Each at the ends of its own steps would be flatter by 0.1, as a
// maximum over few times misses much of the supremum.
TEST(PathOrders, HoldOnAShortHorizonToo) {
  auto scene = load_scene("paper");
  scene.horizon = 0.05;
  const auto s = restricted(bind_scene(scene), {"strang", "magnus"});
  EXPECT_EQ(looks_in_coarsest(asymptotic_levels(s, 256)), 1);
  const auto r = quick_on(s);
  for (const auto* scheme : {"strang", "magnus"})
    for (const auto* text : claims)
      EXPECT_EQ(verdict_of_scheme(r, scheme, text).kind, verdict_kind::holds)
          << verdict_of_scheme(r, scheme, text).reason;
}

double square_between(const std::vector<double>& a, const std::vector<double>& b, std::size_t lane) {
  double square = 0;
  for (std::size_t at = lane; at < a.size(); at += block_lanes) square += std::pow(a[at] - b[at], 2);
  return square;
}

// Against all levels and the truth taken a step at a time, the largest sought at every level's own steps.
TEST(PathOrders, TheLargestIsOverTheEndsOfOwnSteps) {
  const auto s = paper({"magnus"});
  const context c{s, effort::quick};
  const auto grid = asymptotic_levels(s, 256);
  constexpr int cells = 4;
  const noise_source precise{noise_generator::philox, noise_quality::precise};
  const auto driven = driven_kernels_of(s, grid, cells);
  driven_block truth(c, grid, cells, precise, driven, looks_in_coarsest(grid));
  coupled_increments ladder(*s.model, grid, cells, precise);
  largest_errors found(block_lanes, static_cast<int>(grid.steps.size()));
  const auto start = replicated(s.scene.momentum);
  for (std::size_t l = 0; l < grid.steps.size(); ++l) {
    const auto scheme = s.schemes.front().make(grid.dt()[l]);
    auto states = start, alone = start, exact = start;
    std::vector<double> largest(block_lanes);
    truth.start(0);
    int looked = 0;
    for (int chunk = 0; chunk < grid.steps.front(); ++chunk) {
      truth.advance(chunk);
      found.advance(*scheme, truth, l, 0, states);
      const auto fine = ladder.fill(c.seed, 0, chunk);
      const auto& own = ladder.level(l);
      for (int i = 0; i < own.steps; ++i) {
        scheme->advance(alone, own.part(i, 1));
        for (int k = 0, n = fine.steps / own.steps; k < n; ++k) driven.truth->advance(exact, fine.part(i * n + k, 1));
        if (l + 1 == grid.steps.size() && i % 2 == 0) continue;
        ++looked;
        for (std::size_t lane = 0; lane < block_lanes; ++lane)
          largest[lane] = std::max(largest[lane], square_between(alone, exact, lane));
      }
    }
    EXPECT_EQ(looked, std::min(grid.steps[l], grid.steps[grid.steps.size() - 2]));
    for (int lane = 0; lane < block_lanes; ++lane)
      EXPECT_NEAR(std::sqrt(found.squares.at(lane, static_cast<int>(l))),
                  std::sqrt(largest[static_cast<std::size_t>(lane)]), 1e-13);
  }
}

const report::measurement& reference_row(const report::results& r, const std::string& quantity, std::size_t nth = 0) {
  for (const auto& m : r.measurements)
    if (m.quantity == quantity && nth-- == 0) return m;
  throw std::out_of_range(quantity);
}

// Of a spherical body without dissipation nothing moves but by the noise, by isometries. A cell of width d lacks the
// areas, normal to each other and of variance d^2/4, so that E|Y_d - X|^2 -> sigma^4 c^2 T d / 2, and of Y_d and Y_d/2
// half of that.
TEST(PathOrders, TheReferenceIsAsFarAsTheAreasOfItsCells) {
  auto scene = load_scene("paper");
  scene.vector("inertia") = {1, 1, 1};
  scene.number("theta") = 0;
  const auto s = restricted(bind_scene(scene), {"lie_heun"});
  const auto r = quick_on(s);
  const auto grid = asymptotic_levels(s, 256);
  const auto dt = grid.dt();
  const double c = 1, sigma = 0.5, unit = sigma * sigma * c * std::sqrt(grid.horizon / 4);
  for (std::size_t l = dt.size() - 4; l + 1 < dt.size(); ++l) {
    const auto& m = reference_row(r, "distance between references", l);
    EXPECT_NEAR(*m.abscissa(), dt[l], 1e-12);
    const double expected = unit * std::sqrt(*m.abscissa());
    EXPECT_NEAR(*m.value, expected, 2 * (*m.high - *m.low)) << *m.abscissa();
    EXPECT_LT(*m.high - *m.low, 0.2 * expected);
  }
  const auto& rest = reference_row(r, "distance of the reference");
  const double halved = unit * std::sqrt(dt.back() / 32), truly = std::sqrt(2.0) * halved;
  EXPECT_GT(*rest.high, truly);  // the sum of the series bounds it
  EXPECT_NEAR(*rest.value, halved / (1 - std::sqrt(0.5)), 0.1 * *rest.value);
  EXPECT_EQ(verdict_of_scheme(r, "noise", "reference tends to the Stratonovich solution").kind, verdict_kind::holds);
}

TEST(PathOrders, TheReferenceIsOfOrderOneUnderOneVector) {
  auto scene = load_scene("paper");
  scene.vectors("sigma") = {{0.5, 0, 0}};
  const auto r = quick_on(restricted(bind_scene(scene), {"lie_heun"}));
  const auto& v = verdict_of_scheme(r, "noise", "reference tends to the Stratonovich solution");
  EXPECT_EQ(*v.expected, 1);
  EXPECT_EQ(v.kind, verdict_kind::holds) << v.reason;
}

}  // namespace
}  // namespace polhode
