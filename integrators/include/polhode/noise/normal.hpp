// Noise by address: a value is a pure function of (seed, kind, path, step, channel). Nothing is ever drawn in sequence,
// so the number of threads, blocks, packs or ranks changes nothing, and asking for more never changes what was there.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include <polhode/noise/philox.hpp>
#include <polhode/scalar.hpp>
#include <polhode/vec.hpp>

namespace polhode {

/// What a number is used for: equal addresses of different kind are independent.
enum class noise_kind : std::uint16_t { increment = 0, area = 1, initial_state = 2, resampling = 3 };

/// path and step below 2^48.
struct noise_address {
  std::uint64_t seed = 0;
  noise_kind kind = noise_kind::increment;
  std::uint64_t path = 0;
  std::uint64_t step = 0;
};

/// 128 bits at (address, block): the counter is (step: 48 bits, block: 16, path: 48, kind: 16), the key the seed.
inline philox_counter random_bits(const noise_address& a, std::uint32_t block) {
  const auto low = [](std::uint64_t x) { return static_cast<std::uint32_t>(x); };
  const auto high = [](std::uint64_t x) { return static_cast<std::uint32_t>(x >> 32) & 0xFFFFu; };
  const philox_counter counter{low(a.step), high(a.step) | block << 16, low(a.path),
                               high(a.path) | static_cast<std::uint32_t>(a.kind) << 16};
  return philox4x32_10(counter, {low(a.seed), low(a.seed >> 32)});
}

/// A uniform in (0, 1) from 64 bits: the middle of one of 2^52 equal cells, so neither 0 nor 1. (With 2^53 cells the last
/// middle would round to 1.)
inline double uniform_of(std::uint32_t low, std::uint32_t high) {
  const std::uint64_t bits = (std::uint64_t{high} << 32 | low) >> 12;
  return (static_cast<double>(bits) + 0.5) * 0x1p-52;
}

/// Two independent standard normals in double precision (Box, Muller, Ann. Math. Stat. 29 (1958) 610-611).
inline vec<double, 2> normal_pair(const noise_address& address, std::uint32_t block) {
  const auto bits = random_bits(address, block);
  const double radius = std::sqrt(-2.0 * std::log(uniform_of(bits[0], bits[1])));
  const auto [sin, cos] = sincos(2.0 * std::numbers::pi * uniform_of(bits[2], bits[3]));
  return {{radius * cos, radius * sin}};
}

/// The first `wanted` of N independent standard normals; the others are zero and are not computed.
template <int N>
vec<double, N> normals(const noise_address& address, int wanted = N) {
  vec<double, N> out{};
  for (int i = 0; i < wanted; i += 2) {
    const auto pair = normal_pair(address, static_cast<std::uint32_t>(i / 2));
    out[i] = pair[0];
    if (i + 1 < wanted) out[i + 1] = pair[1];
  }
  return out;
}

}  // namespace polhode
