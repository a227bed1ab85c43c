// SPDX-License-Identifier: Apache-2.0
// Standard normals by address, from any source.
#pragma once

#include <polhode/noise/box_muller.hpp>
#include <polhode/noise/quantile.hpp>

namespace polhode {

/// The standard normals of channels 2 pair and 2 pair + 1.
template <noise_generator G>
vec<double, 2> normal_pair(const noise_address& a, std::uint32_t pair, noise_quality quality) {
  if (quality == noise_quality::precise) return normal_pair<double, G>(a, a.path, pair);
  return {{fast_normal<G>(a, 2 * pair), fast_normal<G>(a, 2 * pair + 1)}};
}
inline vec<double, 2> normal_pair(const noise_address& a, std::uint32_t pair, noise_source source = {}) {
  return source.generator == noise_generator::ars ? normal_pair<noise_generator::ars>(a, pair, source.quality)
                                                  : normal_pair<noise_generator::philox>(a, pair, source.quality);
}

/// The first `wanted` of N independent standard normals; the others are zero and are not computed.
template <int N>
requires(N >= 0) vec<double, N> normals(const noise_address& address, int wanted = N, noise_source source = {}) {
  vec<double, N> out{};
  for (int i = 0; i < wanted; i += 2) {
    const auto pair = normal_pair(address, static_cast<std::uint32_t>(i / 2), source);
    out[i] = pair[0];
    if (i + 1 < wanted) out[i + 1] = pair[1];
  }
  return out;
}

}  // namespace polhode
