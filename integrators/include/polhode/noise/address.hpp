// SPDX-License-Identifier: Apache-2.0
// Where a random number lives. A value is a pure function of (seed, kind, path, step, channel): nothing is ever drawn
// in sequence, so the number of threads, blocks, packs or ranks changes nothing, and asking for more never changes what
// was there.
#pragma once

#include <array>
#include <cstdint>

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

/// Where random bits come from. philox: Philox4x32-10, the same speed everywhere; ars: ARS4x32-7, for processors with
/// AES.
enum class noise_generator : std::uint8_t { philox, ars };

/// How bits become normals. precise: Box-Muller in double precision; fast: the quantile in single precision.
enum class noise_quality : std::uint8_t { precise, fast };

struct noise_source {
  noise_generator generator = noise_generator::philox;
  noise_quality quality = noise_quality::precise;
};

/// What a block of 128 bits is spent on, so that no two uses share one: the upper bits of the counter's kind.
enum class block_use : std::uint16_t { precise = 0, fast = 0x8000, fast_tail = 0x4000 };

/// The 128-bit counter as two halves, for one path (B = std::uint64_t) or a pack of them: (step: 48 bits, block: 16),
/// (path: 48, kind and use: 16). address.path is not read.
template <class B>
std::array<B, 2> counter(const noise_address& a, const B& path, std::uint32_t block,
                         block_use use = block_use::precise) {
  constexpr std::uint64_t low_48 = 0xFFFF'FFFF'FFFF;
  const std::uint64_t purpose = static_cast<std::uint64_t>(a.kind) | static_cast<std::uint64_t>(use);
  return {B((a.step & low_48) | std::uint64_t{block} << 48), (path & B(low_48)) | B(purpose << 48)};
}

}  // namespace polhode
