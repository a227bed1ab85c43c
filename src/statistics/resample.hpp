// SPDX-License-Identifier: Apache-2.0
// The bootstrap: indices drawn with replacement, by address.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include <polhode/noise/normal.hpp>

#include "statistics/distributions.hpp"

namespace polhode {

inline constexpr int bootstrap_replicates = 400;

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

/// The interval of what a statistic of `samples` resampled ones gives: the middle of the replicates, taken wider by
/// what resampling few makes too narrow. It holds 2 Phi(sqrt(n / (n - 1)) t) - 1 of them, t Student's quantile of n - 1
/// degrees (the expanded percentile interval; Hesterberg 2015, doi 10.1080/00031305.2015.1089789).
/// All of them where there is but one sample.
inline std::pair<double, double> bootstrap_interval(std::vector<double> replicates, double share, int samples) {
  if (samples < 2) return central_interval(std::move(replicates), 1);
  const double n = samples, t = student_t_quantile((1 + share) / 2, n - 1);
  return central_interval(std::move(replicates), std::erf(std::sqrt(n / (n - 1)) * t / std::numbers::sqrt2));
}

}  // namespace polhode
