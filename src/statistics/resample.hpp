// SPDX-License-Identifier: Apache-2.0
// The bootstrap: indices drawn with replacement, by address.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <polhode/noise/normal.hpp>

namespace polhode {

/// `count` indices below `count`; a pure function of (seed, replicate).
class resample {
 public:
  resample(std::uint64_t seed, int replicate, int count) : indices_(static_cast<std::size_t>(count)) {
    for (int i = 0; i < count; i += 4) {
      const noise_address address{seed, noise_kind::resampling, static_cast<std::uint64_t>(replicate),
                                  static_cast<std::uint64_t>(i / 4)};
      const auto bits = random_words(address, 0);
      for (int k = 0; k < 4 && i + k < count; ++k)
        indices_[static_cast<std::size_t>(i + k)] =
            static_cast<int>(bits[static_cast<std::size_t>(k)] * static_cast<std::uint64_t>(count) >> 32);
    }
  }
  auto begin() const { return indices_.begin(); }
  auto end() const { return indices_.end(); }

 private:
  std::vector<int> indices_;
};

/// The interval that holds the middle `share` of the values (percentile bootstrap).
inline std::pair<double, double> central_interval(std::vector<double> values, double share) {
  std::ranges::sort(values);
  const auto at = [&](double q) {
    const auto i = static_cast<std::size_t>(std::llround(q * static_cast<double>(values.size() - 1)));
    return values[i];
  };
  return {at((1 - share) / 2), at((1 + share) / 2)};
}

}  // namespace polhode
