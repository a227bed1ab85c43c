// SPDX-License-Identifier: Apache-2.0
// What sampled weak errors rest on, each by itself.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include <polhode/noise/normal.hpp>

#include "experiments/weak/common_error.hpp"
#include "experiments/weak/path_controls.hpp"

namespace polhode {
namespace {

constexpr int paths = 2048, levels = 5;

double normal(int path, std::uint64_t which) {
  return normals<1>({7, noise_kind::increment, static_cast<std::uint64_t>(path), which})[0];
}

squared_errors room() { return {paths, levels, std::vector<double>(paths * levels)}; }

// Errors of 3 dt and -8 dt, of observables of size 1 and 2: together |(3, -4)| dt = 5 dt.
TEST(CommonError, IsTheLengthOfTheErrorsInTheirSizes) {
  std::vector<squared_errors> d(2, room());
  for (int p = 0; p < paths; ++p)
    for (int l = 0; l < levels; ++l) {
      const double dt = std::ldexp(1.0, -l);
      d[0].at(p, l) = 3 * dt * (1 + 0.5 * normal(p, 0));
      d[1].at(p, l) = -8 * dt * (1 + 0.5 * normal(p, 1));
    }
  const auto all = along_their_errors(d, std::array{1.0, 2.0}, 5);
  for (int l = 0; l < levels; ++l) {
    const auto m = level_mean(all, l);
    EXPECT_NEAR(m.mean, 5 * std::ldexp(1.0, -l), 4 * m.error) << l;
    EXPECT_LT(m.error, 0.02 * m.mean);
  }
}

// Without any error each half chooses its direction by chance, and the other half does not follow.
TEST(CommonError, OfNoiseIsNone) {
  std::vector<squared_errors> d(8, room());
  for (int p = 0; p < paths; ++p)
    for (int l = 0; l < levels; ++l)
      for (std::size_t f = 0; f < d.size(); ++f) d[f].at(p, l) = normal(p, f);
  const std::vector<double> sizes(d.size(), 1.0);
  const auto m = level_mean(along_their_errors(d, sizes, 5), levels - 1);
  EXPECT_LT(std::fabs(m.mean), 4 * m.error);
}

// y = 1 + 2 W_1 + 3 (W_1 W_2) + 0.1 noise, W of two halves of a path: what the noise explains goes, the mean stays.
TEST(PathControls, TakeOutWhatTheIncrementsExplain) {
  path_controls controls({2, 2}, 2, 1, paths);
  auto y = room();
  for (int first = 0; first < paths; first += block_lanes) {
    std::vector<double> w(2 * block_lanes, 0.0);
    for (int part = 0; part < 2; ++part) {
      std::vector<double> dw(2 * block_lanes);
      for (int lane = 0; lane < block_lanes; ++lane)
        for (int k = 0; k < 2; ++k)
          w[static_cast<std::size_t>(k * block_lanes + lane)] += dw[static_cast<std::size_t>(k * block_lanes + lane)] =
              std::sqrt(0.5) * normal(first + lane, static_cast<std::uint64_t>(2 * part + k));
      controls.keep(first, part, {1, dw, {}});
    }
    for (int lane = 0; lane < block_lanes; ++lane) {
      const double w1 = w[static_cast<std::size_t>(lane)], w2 = w[static_cast<std::size_t>(block_lanes + lane)];
      for (int l = 0; l < levels; ++l) y.at(first + lane, l) = 1 + 2 * w1 + 3 * w1 * w2 + 0.1 * normal(first + lane, 9);
    }
  }
  const auto before = level_mean(y, 0), after = level_mean(controls.taken_out_of({y})[0], 0);
  EXPECT_NEAR(after.mean, 1, 4 * after.error);
  EXPECT_LT(after.error, 0.05 * before.error);  // 0.1 of sqrt(4 + 9)
}

}  // namespace
}  // namespace polhode
