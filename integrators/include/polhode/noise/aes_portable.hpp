// SPDX-License-Identifier: Apache-2.0
// Rounds of AES in plain C++: what the AES instructions do, the same bits (FIPS 197).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace polhode {

/// Low and high half of 128 bits.
using aes_block = std::array<std::uint64_t, 2>;

namespace portable {

/// Multiplication by x in GF(2^8) modulo x^8 + x^4 + x^3 + x + 1.
constexpr std::uint8_t times_x(std::uint8_t a) { return static_cast<std::uint8_t>(a << 1 ^ (a >> 7) * 0x1B); }

/// The inverse in GF(2^8), then the affine map of FIPS 197, section 5.1.1. p runs through the powers of the generator
/// 3, q through their inverses.
constexpr std::array<std::uint8_t, 256> make_s_box() {
  std::array<std::uint8_t, 256> box{};
  box[0] = 0x63;
  std::uint8_t p = 1, q = 1;
  do {
    p = static_cast<std::uint8_t>(p ^ times_x(p));
    for (const int shift : {1, 2, 4}) q = static_cast<std::uint8_t>(q ^ q << shift);
    if (q & 0x80) q ^= 0x09;
    int sum = q;
    for (int turn = 1; turn < 5; ++turn) sum ^= q << turn | q >> (8 - turn);
    box[p] = static_cast<std::uint8_t>(sum ^ 0x63);
  } while (p != 1);
  return box;
}
inline constexpr std::array<std::uint8_t, 256> s_box = make_s_box();

template <bool Last>
constexpr aes_block aes_round(const aes_block& x, const aes_block& key) {
  auto out = key;
  for (unsigned column = 0; column < 4; ++column) {
    std::array<std::uint8_t, 4> s{};
    for (unsigned row = 0; row < 4; ++row) {
      const unsigned from = 4 * ((column + row) % 4) + row;  // ShiftRows
      s[row] = s_box[x[from / 8] >> 8 * (from % 8) & 0xFF];
    }
    for (unsigned row = 0; row < 4; ++row) {
      const std::uint8_t a = s[row], b = s[(row + 1) % 4];
      const int mixed = times_x(static_cast<std::uint8_t>(a ^ b)) ^ b ^ s[(row + 2) % 4] ^ s[(row + 3) % 4];
      out[column / 2] ^= static_cast<std::uint64_t>(Last ? a : mixed) << (32 * (column % 2) + 8 * row);
    }
  }
  return out;
}

/// Key 0 is added; then rounds of S-box, ShiftRows, MixColumns except in the last, and key.
template <std::size_t Keys>
constexpr aes_block aes(const aes_block& x, const std::array<aes_block, Keys>& keys) {
  aes_block s{x[0] ^ keys[0][0], x[1] ^ keys[0][1]};
  for (std::size_t i = 1; i + 1 < Keys; ++i) s = aes_round<false>(s, keys[i]);
  return aes_round<true>(s, keys[Keys - 1]);
}

}  // namespace portable
}  // namespace polhode
