// SPDX-License-Identifier: Apache-2.0
// The driven equation on a block of paths against Boost.Odeint on each of its segments, and its derivatives against
// central differences of that.
#include "experiments/common/driven_block.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "ensemble/noise/paths.hpp"
#include "references/odeint.hpp"
#include "run/bind_scene.hpp"
#include "scene/scene.hpp"

namespace polhode {
namespace {

using state = std::vector<double>;
using rows = std::vector<state>;  // [step][channel]

/// Increments of one lane, each channel's times its factor.
rows increments_of(const increment_view& v, int lane, const std::vector<double>& factors) {
  rows out;
  const std::size_t each = v.dw.size() / static_cast<std::size_t>(v.steps);
  for (int step = 0; step < v.steps; ++step) {
    state dw;
    for (std::size_t k = 0; k < factors.size(); ++k)
      dw.push_back(factors[k] * v.dw[static_cast<std::size_t>(step) * each + k * block_lanes + std::size_t(lane)]);
    out.push_back(dw);
  }
  return out;
}

/// dmu/ds = dt drift(mu) + sum_k dw^k ad*_{sigma_k} mu, s from 0 to 1, one segment after another.
state along(const subject& s, state mu, const rows& dw, double dt) {
  for (const auto& segment : dw) {
    state xi(mu.size(), 0.0), turned(mu.size());
    for (std::size_t k = 0; k < segment.size(); ++k)
      for (std::size_t i = 0; i < xi.size(); ++i) xi[i] += segment[k] * s.scene.vectors(noise_key)[k][i];
    mu = solve_drift(
        [&](std::span<const double> x, std::span<double> out) {
          s.model->drift(x, out);
          s.model->coadjoint(xi, x, turned);
          for (std::size_t i = 0; i < out.size(); ++i) out[i] = dt * out[i] + turned[i];
        },
        mu, 1);
  }
  return mu;
}

struct driven : testing::Test {
  static constexpr int chunks = 2, cells = 2;
  static constexpr double short_time = 0.0625;
  const level_grid grid{short_time, {chunks, 2 * chunks, 4 * chunks, 8 * chunks}};
  static constexpr std::size_t varied = 1;  // of four levels

  static subject paper() {
    auto scene = load_scene("paper");
    scene.horizon = short_time;
    return bind_scene(scene);
  }

  /// Increments of the whole path: of the fine cells, or of a level.
  rows noise_of(const subject& s, int lane, int level, const std::vector<double>& factors) {
    const auto kernels = driven_kernels_of(s, grid, cells);
    const context c{.subject = s, .seed = 3};
    driven_block block(c, grid, cells, {}, kernels);
    block.start(64);
    rows out;
    for (int chunk = 0; chunk < chunks; ++chunk) {
      block.advance(chunk);
      const auto& v = level < 0 ? block.fine() : block.increments(std::size_t(level));
      for (auto& row : increments_of(v, lane, factors)) out.push_back(row);
    }
    return out;
  }
};

TEST_F(driven, DirectionsAreWhatTheSystemHas) {
  const auto names = [&](const subject& s) {
    std::vector<std::string> out;
    for (const auto& d : driven_kernels_of(s, grid, cells).directions) out.push_back(d.name);
    return out;
  };
  const auto s = paper();
  EXPECT_EQ(names(s), (std::vector<std::string>{"noise 1", "noise 2", "noise 3", "dissipation", "time"}));
  EXPECT_EQ(names(s.without_dissipation()), (std::vector<std::string>{"noise 1", "noise 2", "noise 3", "time"}));
  const auto one = s.with(with_noise_vectors(s.scene, {{0.3, 0.2, 0.1}}));
  EXPECT_EQ(names(one), (std::vector<std::string>{"noise", "dissipation", "time"}));
}

TEST_F(driven, TruthAndTwinsAreTheEquationDrivenByTheirIncrements) {
  const auto s = paper();
  const auto kernels = driven_kernels_of(s, grid, cells);
  const context c{.subject = s, .seed = 3};
  driven_block block(c, grid, cells, {}, kernels, 2);
  for (int again = 0; again < 2; ++again) {  // a start forgets what was before
    block.start(64);
    for (int chunk = 0; chunk < chunks; ++chunk) block.advance(chunk);
  }
  for (const int lane : {0, 41}) {
    const auto fine = noise_of(s, lane, -1, {1, 1, 1});
    const double dt = short_time / static_cast<double>(fine.size());
    const auto truth = along(s, s.scene.momentum, fine, dt);
    const auto quarter = static_cast<long>(fine.size() / 4);
    const auto on_the_way = along(s, s.scene.momentum, {fine.begin(), fine.end() - quarter}, dt);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(lane_of(block.truth(), lane, 3)[std::size_t(i)], truth[std::size_t(i)], 1e-9);
      EXPECT_NEAR(lane_of(block.course()[0], lane, 3)[std::size_t(i)], on_the_way[std::size_t(i)], 1e-9);
    }
    for (int level = 0; level < 4; ++level) {
      const double step = grid.dt()[std::size_t(level)];
      const auto twin = along(s, s.scene.momentum, noise_of(s, lane, level, {1, 1, 1}), step);
      for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(lane_of(block.twin(std::size_t(level)), lane, 3)[std::size_t(i)], twin[std::size_t(i)],
                    1e-5 * step);
    }
  }
}

TEST_F(driven, TruthIsKeptAtTheEndOfAStepUnlessAskedFor) {
  const auto s = paper();
  const auto kernels = driven_kernels_of(s, grid, cells);
  const context c{.subject = s, .seed = 3};
  EXPECT_EQ(driven_block(c, grid, cells, {}, kernels).course().size(), 1u);
  EXPECT_EQ(driven_block(c, grid, cells, {}, kernels, 4).course().size(), 4u);
}

TEST_F(driven, ResponsesAreTheDerivativesOfItsTwin) {
  const auto s = paper();
  const auto kernels = driven_kernels_of(s, grid, cells);
  const context c{.subject = s, .seed = 3};
  driven_block block(c, grid, cells, {}, kernels);
  block.start(64);
  for (int chunk = 0; chunk < chunks; ++chunk) block.advance(chunk);
  const auto responses = block.responses();
  ASSERT_EQ(responses.size(), 5u);
  const double step = grid.dt()[varied], change = 1e-4, damping = dissipation_of(s.scene);
  for (const int lane : {0, 63})
    for (std::size_t k = 0; k < 5; ++k) {
      const auto with = [&](double factor) {
        std::vector<double> factors(3, 1.0);
        if (k < 3) factors[k] = factor;
        const auto noise = noise_of(s, lane, varied, factors);
        const auto other = k == 3 ? s.with(with_dissipation(s.scene, damping * factor)) : s;
        return along(other, s.scene.momentum, noise, step * (k == 4 ? factor : 1));
      };
      const auto ahead = with(1 + change), behind = with(1 - change);
      const auto found = lane_of(responses[k], lane, 3);
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(found[i], (ahead[i] - behind[i]) / (2 * change), 1e-6) << lane << ' ' << k << ' ' << i;
    }
}

}  // namespace
}  // namespace polhode
