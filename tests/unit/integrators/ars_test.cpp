// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

#include <polhode/noise/block_source.hpp>
#include <polhode/simd.hpp>

namespace polhode {
namespace {

using words = std::array<std::uint64_t, 4>;

template <std::size_t Rounds>
words ars_words(const words& counter, const words& key) {
  const auto halves = [](const words& w) { return aes_block{w[0] | w[1] << 32, w[2] | w[3] << 32}; };
  const auto out = ars4x32<Rounds>(halves(counter), halves(key));
  return {out[0] & 0xFFFFFFFF, out[0] >> 32, out[1] & 0xFFFFFFFF, out[1] >> 32};
}

// Known answers of the Random123 distribution (kat_vectors and old_kat_vectors, ars4x32).
TEST(Ars, KnownAnswersOfSevenRounds) {
  EXPECT_EQ(ars_words<7>({1, 0, 0, 0}, {1, 0, 0, 0}), (words{0x3523162b, 0xdc14d20c, 0x79184077, 0x72184193}));
  EXPECT_EQ(ars_words<7>({0, 0, 0, 0x80}, {1, 0, 0, 0}), (words{0x888951cd, 0xb983f2dd, 0x673d28ca, 0x9715cfb2}));
  EXPECT_EQ(ars_words<7>({0x886a3f24, 0xd308a385, 0x2e8a1913, 0x44737003}, {1, 0, 0, 0}),
            (words{0xbb4006c7, 0x33dbc0db, 0x1ea0a1c9, 0x7f9541e3}));
  EXPECT_EQ(ars_words<7>({0x886a3f24, 0xd308a385, 0x2e8a1913, 0x44737003}, {0, 0, 0, 0x80000000}),
            (words{0x31e3f0cc, 0x92d1e3cc, 0xa2fdaa6c, 0x902c741b}));
}

TEST(Ars, KnownAnswersOfTenRounds) {
  EXPECT_EQ(ars_words<10>({0, 0, 0, 0}, {0, 0, 0, 0}), (words{0x8d73ee19, 0x506401ef, 0x13c2dbe4, 0x0cbe9c0d}));
  EXPECT_EQ(
      ars_words<10>({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0, 0x082efa98, 0xec4e6c89}),
      (words{0xa516e7d6, 0x8357ad74, 0x5b59b3ec, 0x8763fff3}));
  EXPECT_EQ(ars_words<10>({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff, 0, 0}),
            (words{0xbb3743b1, 0x9f635551, 0xecbc87fc, 0xa19478a9}));
}

// Packs of two blocks and more take the portable twin here; the instructions are held to it by NormalBlock.
TEST(Ars, PacksGiveTheSameBits) {
  using B = stdx::fixed_size_simd<std::uint64_t, 8>;
  const B low([](std::size_t i) { return 0x0123456789ABCDEF * (i + 1); }), high([](std::size_t i) { return 77 * i; });
  const auto packed = random_bits<noise_generator::ars>(std::array{low, high}, 0xDEADBEEF12345678);
  for (std::size_t i = 0; i < 8; ++i) {
    const auto one = random_bits<noise_generator::ars>(aes_block{low[i], high[i]}, 0xDEADBEEF12345678);
    for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(packed[k][i], one[k]);
  }
}

// Of each pack first the blocks of its even lanes, then those of its odd, low half and high half side by side.
template <noise_generator G>
void expect_blocks() {
  using B = bits_of<pack>;
  std::array<std::array<B, 2>, 3> counters;
  for (std::size_t n = 0; n < 3; ++n)
    counters[n] = {B([&](std::size_t i) { return 0x9E3779B97F4A7C15 * (i + 10 * n + 1); }),
                   B([&](std::size_t i) { return 77 * i + n; })};
  const auto blocks = block_source<G, B>(0xDEADBEEF12345678)(counters);
  for (std::size_t n = 0; n < 3; ++n)
    for (std::size_t i = 0; i < B::size(); ++i) {
      const auto one =
          random_bits<G>(std::array<std::uint64_t, 2>{counters[n][0][i], counters[n][1][i]}, 0xDEADBEEF12345678);
      for (std::size_t half = 0; half < 2; ++half)
        EXPECT_EQ(blocks[2 * n + i % 2][i / 2 * 2 + half], one[half]) << n << ' ' << i;
    }
}

TEST(BlockSource, GivesEvenLanesThenOddOnes) {
  if (pack::size() < 2) GTEST_SKIP() << "one lane";
  expect_blocks<noise_generator::philox>();
  expect_blocks<noise_generator::ars>();
}

// Intrinsics of this compilation against their twins, bit by bit.
TEST(Simd, TwinsGiveTheSameBits) {
  using B = bits_of<pack>;
  const B a([](std::size_t i) { return 0x9E3779B97F4A7C15 * (i + 1); }),
      b([](std::size_t i) { return 0xBB67AE8584CAA73B * (i + 3); });
  const auto left = interleave(a, b), right = twin::interleave(a, b), back = interleave(left[0], left[1]);
  for (std::size_t k = 0; k < 2; ++k) EXPECT_TRUE(stdx::all_of(left[k] == right[k]));
  EXPECT_TRUE(stdx::all_of(back[0] == a) && stdx::all_of(back[1] == b));
  for (std::size_t i = 0; i < B::size(); ++i) {
    EXPECT_EQ(multiply_low_words(a, b)[i], multiply_low_words(a[i], b[i]));
    EXPECT_EQ(join_low_words(a, b)[i], join_low_words(a[i], b[i]));
  }
}

TEST(Simd, FusedRoundsOnce) {
  using F = stdx::native_simd<float>;
  const float a = 1 + 0x1p-12F;  // a a = 1 + 2^-11 + 2^-24
  EXPECT_EQ(fused(a, a, -1 - 0x1p-11F), 0x1p-24F);
  EXPECT_TRUE(stdx::all_of(fused(F(a), F(a), F(-1 - 0x1p-11F)) == F(0x1p-24F)));
}

TEST(Simd, FloatsAreCut) {
  using U = stdx::rebind_simd_t<std::uint32_t, stdx::native_simd<float>>;
  for (std::uint32_t i = 0; i < 100'000; ++i) {
    const std::uint32_t a = (i * 2654435769u & 0x7FFFFFFF) >> i % 16;
    const int dropped = std::max(0, 8 - std::countl_zero(a));
    const auto expected = static_cast<float>(a >> dropped << dropped);
    EXPECT_EQ(cut_to_float(a), expected);
    EXPECT_EQ(cut_to_float(U(a))[0], expected);
  }
}

}  // namespace
}  // namespace polhode
