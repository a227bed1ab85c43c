// SPDX-License-Identifier: Apache-2.0
// Precise normals: Box-Muller in double precision, two from 128 bits.
// Compiled without contraction of products and sums the bits are the same on every instruction set.
#pragma once

#include <numbers>

#include <polhode/noise/random_bits.hpp>
#include <polhode/scalar.hpp>
#include <polhode/vec.hpp>

namespace polhode {

/// A uniform in (0, 1) from 64 bits: the middle of one of 2^52 equal cells, so neither 0 nor 1. (With 2^53 cells the
/// last middle would round to 1.) Exact: 1 + k 2^-52 is written bit by bit and 1 - 2^-53 taken off.
template <class S, class B>
S uniform_of(const B& bits) {
  return std::bit_cast<S>(B(bits >> 12 | B(std::uint64_t{0x3FF0000000000000}))) - S(1 - 0x1p-53);
}

/// Two independent standard normals (Box, Muller, Ann. Math. Stat. 29 (1958) 610-611). The address's path is not read.
template <class S, noise_generator G = noise_generator::philox, class B>
vec<S, 2> normal_pair(const noise_address& address, const B& path, std::uint32_t block) {
  const auto bits = random_bits<G>(counter(address, path, block), address.seed);
  const S radius = square_root(S(S(-2.0) * logarithm(uniform_of<S>(bits[0]))));
  const auto [sin, cos] = detail::sincos_reduced(S(S(2 * std::numbers::pi) * uniform_of<S>(bits[1])));
  return {{radius * cos, radius * sin}};
}

}  // namespace polhode
