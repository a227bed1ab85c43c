// SPDX-License-Identifier: Apache-2.0
// The audit of few numbers is no surer than it may be, and paths heard one by one are judged as if heard together.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <polhode/noise/normal.hpp>

#include "statistics/noise/noise_audit.hpp"

namespace polhode {
namespace {

constexpr int active_channels = 3;

/// [step][channel] of one path.
std::vector<double> path_of(std::uint64_t seed, std::uint64_t path, int steps) {
  std::vector<double> dw;
  for (int i = 0; i < steps; ++i) {
    const auto z = normals<active_channels>({seed, noise_kind::increment, path, static_cast<std::uint64_t>(i)});
    for (int k = 0; k < active_channels; ++k) dw.push_back(z[k]);
  }
  return dw;
}

noise_audit one_path(std::uint64_t seed, int path, int steps) {
  noise_audit a(active_channels, 0);
  const auto dw = path_of(seed, static_cast<std::uint64_t>(path), steps);
  a.add_path({steps, active_channels, 0, dw, {}, {}, 1.0}, path);
  return a;
}

// 320 numbers a channel: of the fourth moment, were it not left out, one run in a thousand lies beyond.
TEST(ShortAudit, IsNotSurerThanItMayBe) {
  int runs = 4000, variances = 0, far = 0;
  for (int seed = 1; seed <= runs; ++seed) {
    const auto found = one_path(static_cast<std::uint64_t>(seed), 0, 330).deviations();
    for (const auto& d : found) {
      EXPECT_LT(std::fabs(d.z), audit_threshold(found.size())) << seed << ": " << d.what;
      if (!d.what.starts_with("variance")) continue;
      ++variances;
      far += std::fabs(d.z) > 3.0902323061678132;  // 0.2 %
    }
  }
  EXPECT_EQ(variances, active_channels * runs);
  EXPECT_NEAR(far, 0.002 * variances, 4 * std::sqrt(0.002 * variances));
}

TEST(ShortAudit, SeesWhatIsGross) {
  auto dw = path_of(1, 0, 330);
  for (double& x : dw) x *= 1.5;
  noise_audit a(active_channels, 0);
  a.add_path({330, active_channels, 0, dw, {}, {}, 1.0}, 0);
  double worst = 0;
  for (const auto& d : a.deviations())
    if (d.what.starts_with("variance")) worst = std::max(worst, d.z);
  EXPECT_GT(worst, audit_threshold(a.deviations().size()));
}

// All but the products inside 64 steps, of which one path's every 4096th is taken, and so the first of each.
TEST(ShortAudit, OfPathsJoinedIsThatOfTheirBlock) {
  constexpr int paths = 64, steps = 1024;
  noise_audit together(active_channels, 0), joined(active_channels, 0);
  for (int path = 0; path < paths; ++path) {
    const auto dw = path_of(5, static_cast<std::uint64_t>(path), steps);
    together.add_path({steps, active_channels, 0, dw, {}, {}, 1.0}, path);
    joined.join(one_path(5, path, steps));
  }
  const auto a = together.deviations(), b = joined.deviations();
  ASSERT_EQ(a.size(), b.size());
  EXPECT_GT(a.size(), 20u);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].what, b[i].what);
    if (a[i].what == "product of two steps within 64") continue;
    EXPECT_NEAR(a[i].z, b[i].z, 1e-9) << a[i].what;
  }
}

// A start of one number is alike far more often than one of four.
TEST(ShortAudit, StartsAreAsRareAsTheShortest) {
  const auto block = [](std::uint64_t seed, int steps) {
    std::vector<double> z(static_cast<std::size_t>(steps * path_audit::lanes));
    for (std::size_t i = 0; i < z.size(); ++i) z[i] = path_of(seed, i, 1)[0];
    return z;
  };
  path_audit four, one;
  four.add_starts(block(1, 4).data(), 4, 1, 1);
  auto alike = block(2, 1);
  alike[1] = alike[0];
  one.add_starts(alike.data(), 1, 1, 1);
  four.merge(one);
  EXPECT_NEAR(four.probability_of_repeats(), 64 * 127 * path_audit::same_number, 1e-15);
}

}  // namespace
}  // namespace polhode
