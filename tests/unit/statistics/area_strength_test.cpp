// SPDX-License-Identifier: Apache-2.0
// How strongly areas are felt is found beside a scheme's own larger error, and is not made up where there are none.
#include <gtest/gtest.h>

#include <cmath>
#include <polhode/noise/normal.hpp>
#include <vector>

#include "statistics/noise/area_strength.hpp"

namespace polhode {
namespace {

constexpr int levels = 8, cells = 32;

std::vector<double> steps() {
  std::vector<double> dt;
  for (int l = 0; l < levels; ++l) dt.push_back(0.25 * std::exp2(-l));
  return dt;
}

/// What the areas do is areas sqrt(dt) g + drift dt h, the error eps times the former and own dt (h + k) / 2: normal
/// vectors g, h, k of three components, h and k once a path, as drift remembers its path.
struct synthetic {
  double areas, drift, own, eps;
};
area_response response_of(const synthetic& s, int paths, std::uint64_t seed) {
  const auto room = std::vector<double>(static_cast<std::size_t>(paths * levels));
  area_response out{{paths, levels, room}, {paths, levels, room}};
  const auto dt = steps();
  for (int p = 0; p < paths; ++p)
    for (int l = 0; l < levels; ++l) {
      const auto path = static_cast<std::uint64_t>(p), level = static_cast<std::uint64_t>(l);
      const auto g = normals<3>({seed, noise_kind::increment, path, level});
      const auto h = normals<3>({seed, noise_kind::area, path, 0}), k = normals<3>({seed, noise_kind::area, path, 1});
      const double h_step = dt[static_cast<std::size_t>(l)];
      for (int i = 0; i < 3; ++i) {
        const double by_areas = s.areas * std::sqrt(h_step) * g[i], by_drift = s.drift * h_step * h[i];
        const double error = s.eps * by_areas + s.own * h_step * (h[i] + k[i]) / 2;
        out.product.at(p, l) += (by_areas + by_drift) * error;
        out.square.at(p, l) += std::pow(by_areas + by_drift, 2);
      }
    }
  return out;
}

multiplier strength(const synthetic& s, int paths = 320, std::uint64_t seed = 1) {
  return area_strength(steps(), response_of(s, paths, seed), paths, cells);
}

TEST(AreaStrength, IsOneOfHealthySchemes) {
  int covered = 0;
  constexpr int seeds = 200;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const auto m = strength({1, 1, 2, 0}, 320, seed);
    ASSERT_TRUE(m.known);
    EXPECT_LT(std::fabs(m.error.value), m.sure) << seed;
    covered += m.error.low <= 0 && 0 <= m.error.high;
  }
  EXPECT_GE(covered, 0.95 * seeds - 4 * std::sqrt(0.05 * 0.95 * seeds));
}

TEST(AreaStrength, FivePerCentAreSeenBesideALargerErrorOfTheScheme) {
  for (const double eps : {-1.0, -0.05, 0.05}) {
    const auto m = strength({1, 1, 0.2, eps});
    ASSERT_TRUE(m.known);
    EXPECT_GT(std::fabs(m.error.value), m.sure) << eps;
    EXPECT_NEAR(m.error.value, eps, m.sure);
  }
}

TEST(AreaStrength, IsNotKnownWhereTheNoiseCommutes) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    EXPECT_FALSE(strength({0, 1, 1, 0}, 320, seed).known) << seed;
    EXPECT_FALSE(strength({0, 0, 1, 0}, 320, seed).known) << seed;
  }
}

}  // namespace
}  // namespace polhode
