// SPDX-License-Identifier: Apache-2.0
// Paths that repeat or follow each other are seen, one among 64 as well, and healthy ones are not taken for such.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "ensemble/kernel.hpp"
#include "ensemble/noise/normal_block.hpp"
#include "statistics/noise/noise_audit.hpp"

namespace polhode {
namespace {

constexpr int channels = 3;

std::vector<float> fast_normals(std::uint64_t seed, std::uint64_t first_path, int steps) {
  std::vector<float> out(static_cast<std::size_t>(steps * channels * block_lanes));
  normal_block request{seed, noise_kind::increment, first_path, 0, steps, channels, channels, 1, nullptr};
  request.source.quality = noise_quality::fast;
  request.singles = out.data();
  fill_normals(request);
  return out;
}

/// What is wrong with the numbers of one block; at(step, channel, lane).
struct spoilt_block {
  std::vector<float>& z;
  int steps;
  float& at(int step, int channel, int lane) {
    return z[static_cast<std::size_t>((step * channels + channel) * block_lanes + lane)];
  }
  void mix(int into, int from, double correlation) {
    for (int i = 0; i < steps; ++i)
      for (int k = 0; k < channels; ++k)
        at(i, k, into) = static_cast<float>(correlation * at(i, k, from) +
                                            std::sqrt(1 - correlation * correlation) * at(i, k, into));
  }
};

struct run_shape {
  int blocks, steps;
};
noise_audit audited(std::uint64_t seed, run_shape shape, const std::function<void(spoilt_block)>& spoil = {}) {
  noise_audit all(channels, 0);
  for (int b = 0; b < shape.blocks; ++b) {
    auto z = fast_normals(seed, static_cast<std::uint64_t>(b) * block_lanes, shape.steps);
    if (spoil) spoil({z, shape.steps});
    noise_audit one(channels, 0);
    one.add({shape.steps, channels, 0, {}, z, {}, 0.01});
    all.merge(one);
  }
  return all;
}

double deviation(const noise_audit& a, const std::string& what) {
  for (const auto& d : a.deviations())
    if (d.what == what) return d.z;
  ADD_FAILURE() << "no " << what;
  return 0;
}
constexpr const char* alike = "number of paths that start alike";
constexpr const char* products = "product of two lanes";

double threshold(const noise_audit& a) { return audit_threshold(a.deviations().size()); }

// The largest product's probability is uniform: a tenth of 400 seeds lie below a tenth, but for Bonferroni's bound,
// which is short by a twentieth of it here.
TEST(PathAudit, HealthyPathsAreNotSuspected) {
  int rare = 0;
  constexpr int seeds = 400;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const auto a = audited(seed, {4, 256});
    EXPECT_EQ(deviation(a, alike), 0) << seed;
    const double z = deviation(a, products);
    EXPECT_LT(z, threshold(a)) << seed;
    rare += z > 1.6448536269514722;  // two-sided 0.1
  }
  EXPECT_NEAR(rare, 0.095 * seeds, 4 * std::sqrt(0.1 * 0.9 * seeds));
}

TEST(PathAudit, OnePathAmong64ThatRepeatsAnotherIsSeenByItsFirstSteps) {
  const auto a = audited(1, {1, 4}, [](spoilt_block b) { b.mix(63, 17, 1); });
  EXPECT_GT(deviation(a, alike), threshold(a));
}

TEST(PathAudit, APathThatRepeatsOneOfAnotherBlockIsSeen) {
  std::vector<float> kept;
  const auto a = audited(1, {3, 4}, [&](spoilt_block b) {
    if (kept.empty()) kept = b.z;
    spoilt_block first{kept, b.steps};
    for (int i = 0; i < b.steps; ++i)
      for (int k = 0; k < channels; ++k) b.at(i, k, 5) = first.at(i, k, 40);
  });
  EXPECT_GT(deviation(a, alike), threshold(a));
}

TEST(PathAudit, TwoLanesThatFollowEachOtherAreSeen) {
  const auto a = audited(1, {10, 2048}, [](spoilt_block b) { b.mix(50, 3, 0.5); });
  EXPECT_EQ(deviation(a, alike), 0);
  EXPECT_GT(deviation(a, products), threshold(a));
}

TEST(PathAudit, OnePathAtATimeIsComparedAsWell) {
  for (const bool repeated : {false, true}) {
    noise_audit a(channels, 0);
    for (int path = 0; path < 8; ++path) {
      const auto z = fast_normals(1, 64, 256);
      std::vector<double> dw(256 * channels);
      for (std::size_t i = 0; i < dw.size(); ++i) dw[i] = double{z[i * block_lanes + (repeated ? path / 2 : path)]};
      a.add_path({256, channels, 0, dw, {}, {}, 1.0}, path);
    }
    EXPECT_EQ(deviation(a, alike) > threshold(a), repeated);
  }
}

// What the header says of two fast normals being alike, against 2^20 of them.
TEST(PathAudit, KnowsHowRarelyNumbersAreAlike) {
  std::vector<float> z;
  for (std::uint64_t block = 0; z.size() < 1 << 20; ++block) {
    const auto more = fast_normals(3, block * block_lanes, 64);
    z.insert(z.end(), more.begin(), more.end());
  }
  std::ranges::sort(z);
  double pairs = 0;
  for (std::size_t i = 0, run = 1; i + 1 < z.size(); ++i) {
    run = z[i] == z[i + 1] ? run + 1 : 1;
    pairs += static_cast<double>(run - 1);
  }
  const auto n = static_cast<double>(z.size());
  const double expected = n * (n - 1) / 2 * path_audit::same_number;
  EXPECT_LT(pairs, expected);
  EXPECT_GT(pairs, expected / 2);
}

}  // namespace
}  // namespace polhode
