// Noise by address: a value is a pure function of (seed, kind, path, step, channel). Nothing is ever drawn in sequence,
// so the number of threads, blocks, packs or ranks changes nothing, and asking for more never changes what was there.
// Compiled without contraction of products and sums the bits are the same on every instruction set.
#pragma once

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

/// 128 bits at (address, block) for every path in B (one path, or a pack of them): the counter is (step: 48 bits,
/// block: 16, path: 48, kind: 16), the key the seed. address.path is not read.
template <class B>
philox_words<B> random_words(const noise_address& a, const B& path, std::uint32_t block) {
  const std::uint64_t word = 0xFFFFFFFF;
  return philox4x32_10<B>(
      {B(a.step & word), B((a.step >> 32 & 0xFFFF) | std::uint64_t{block} << 16), path & B(word),
       (path >> 32 & B(std::uint64_t{0xFFFF})) | B(std::uint64_t{static_cast<std::uint16_t>(a.kind)} << 16)},
      a.seed);
}
inline philox_words<std::uint64_t> random_words(const noise_address& a, std::uint32_t block) {
  return random_words<std::uint64_t>(a, a.path, block);
}

/// A uniform in (0, 1) from 64 bits: the middle of one of 2^52 equal cells, so neither 0 nor 1. (With 2^53 cells the
/// last middle would round to 1.) Exact: 1 + k 2^-52 is written bit by bit and 1 - 2^-53 taken off.
template <class S, class B>
S uniform_of(const B& low, const B& high) {
  const B mantissa = (high << 32 | low) >> 12;
  return std::bit_cast<S>(B(mantissa | B(std::uint64_t{0x3FF0000000000000}))) - S(1 - 0x1p-53);
}

/// Two independent standard normals in double precision (Box, Muller, Ann. Math. Stat. 29 (1958) 610-611).
template <class S, class B>
vec<S, 2> normal_pair(const noise_address& address, const B& path, std::uint32_t block) {
  const auto words = random_words(address, path, block);
  const S radius = square_root(S(S(-2.0) * logarithm(uniform_of<S>(words[0], words[1]))));
  const auto [sin, cos] = detail::sincos_reduced(S(S(2 * std::numbers::pi) * uniform_of<S>(words[2], words[3])));
  return {{radius * cos, radius * sin}};
}
inline vec<double, 2> normal_pair(const noise_address& address, std::uint32_t block) {
  return normal_pair<double>(address, address.path, block);
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
