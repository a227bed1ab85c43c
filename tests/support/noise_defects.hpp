// SPDX-License-Identifier: Apache-2.0
// Broken noise, one thing at a time, for ensemble/noise/noise_defect.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>

#include "ensemble/kernel.hpp"
#include "ensemble/noise/noise_defect.hpp"

namespace polhode::test {

/// Calls f on the increments of every row (step, channel) in units of standard normals, whichever way they are kept.
inline void each_increment(const drawn_noise& n,
                           const std::function<double(int step, int channel, int lane, double z)>& f) {
  if (n.coarsened) return;
  const double unit = n.singles.empty() ? std::sqrt(n.dt) : 1;
  for (int i = 0; i < n.steps; ++i)
    for (int k = 0; k < n.layout.channels; ++k)
      for (int lane = 0; lane < n.lanes; ++lane) {
        const auto at = static_cast<std::size_t>((i * n.layout.channels + k) * n.lanes + lane);
        if (n.singles.empty())
          n.dw[at] = unit * f(i, k, lane, n.dw[at] / unit);
        else
          n.singles[at] = static_cast<float>(f(i, k, lane, double{n.singles[at]}));
      }
}

/// As it is kept, to be read by another lane, channel or step.
inline double increment_at(const drawn_noise& n, int step, int channel, int lane) {
  const auto at = static_cast<std::size_t>((step * n.layout.channels + channel) * n.lanes + lane);
  return n.singles.empty() ? n.dw[at] / std::sqrt(n.dt) : double{n.singles[at]};
}

struct increments_times final : noise_defect {
  double factor;
  explicit increments_times(double f) : factor(f) {}
  void spoil(const drawn_noise& n) const override {
    each_increment(n, [&](int, int, int, double z) { return factor * z; });
  }
};

/// Channel 2 takes `correlation` of channel 1.
struct channels_correlated final : noise_defect {
  double correlation;
  explicit channels_correlated(double c) : correlation(c) {}
  void spoil(const drawn_noise& n) const override {
    each_increment(n, [&](int i, int k, int lane, double z) {
      return k == 1 ? correlation * increment_at(n, i, 0, lane) + std::sqrt(1 - correlation * correlation) * z : z;
    });
  }
};

struct lanes_repeated final : noise_defect {
  std::uint64_t path(std::uint64_t own) const override { return own % 64 < 32 ? own : own - 32; }
  void spoil(const drawn_noise& n) const override {
    if (n.lanes == 1) return;
    each_increment(n,
                   [&](int i, int k, int lane, double z) { return lane < 32 ? z : increment_at(n, i, k, lane - 32); });
  }
};

/// Every second block is the one before it; of a common noise, every second path.
struct blocks_repeated final : noise_defect {
  std::uint64_t path(std::uint64_t own) const override { return own % 64 == 0 ? own / 128 * 128 : own / 2 * 2; }
};

/// Every second step has the increments of the one before it.
struct steps_reused final : noise_defect {
  void spoil(const drawn_noise& n) const override {
    each_increment(n, [&](int i, int k, int lane, double z) {
      return (n.first_step + static_cast<std::uint64_t>(i)) % 2 == 1 && i > 0 ? increment_at(n, i - 1, k, lane) : z;
    });
  }
};

struct tail_clipped final : noise_defect {
  double at;
  explicit tail_clipped(double limit) : at(limit) {}
  void spoil(const drawn_noise& n) const override {
    each_increment(n, [&](int, int, int, double z) { return std::clamp(z, -at, at); });
  }
};

struct area_variance_times final : noise_defect {
  double factor;
  explicit area_variance_times(double f) : factor(f) {}
  void spoil(const drawn_noise& n) const override {
    for (double& a : n.area) a *= std::sqrt(factor);
  }
};

}  // namespace polhode::test
