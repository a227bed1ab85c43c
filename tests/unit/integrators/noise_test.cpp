// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include <polhode/increment.hpp>
#include <polhode/noise/normal.hpp>
#include <polhode/simd.hpp>

#include "support/noise_sources.hpp"

namespace polhode {
namespace {

using four_words = philox_words<std::uint64_t>;

four_words philox4x32_10(const four_words& counter, std::uint64_t seed) {
  four_words out = philox<std::uint64_t>(seed).words(std::to_array({counter}))[0];
  for (auto& word : out) word &= 0xFFFFFFFF;
  return out;
}

// The format of docs/reproducibility.md: with another one every seed would have other noise.
TEST(NoiseAddress, IsTwoHalvesOfStepAndBlockAndOfPathKindAndUse) {
  const std::uint64_t step = 0x0123'4567'89AB, path = 0xBA98'7654'3210;
  const std::pair<noise_kind, std::uint64_t> kinds[] = {
      {noise_kind::increment, 0}, {noise_kind::area, 1}, {noise_kind::initial_state, 2}, {noise_kind::resampling, 3}};
  const std::pair<block_use, std::uint64_t> uses[] = {
      {block_use::precise, 0}, {block_use::fast, 0x8000}, {block_use::fast_tail, 0x4000}};
  for (const auto& [kind, of_kind] : kinds)
    for (const auto& [use, of_use] : uses) {
      const auto c = counter<std::uint64_t>({7, kind, 99, step}, path, 5, use);
      EXPECT_EQ(c[0], step + (std::uint64_t{5} << 48));
      EXPECT_EQ(c[1], path + ((of_kind + of_use) << 48));
    }
}

// Known answers of the Random123 distribution (kat_vectors, philox4x32-10).
TEST(Philox, KnownAnswers) {
  EXPECT_EQ(philox4x32_10({0, 0, 0, 0}, 0), (four_words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox4x32_10({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, 0xffffffffffffffff),
            (four_words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox4x32_10({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, 0x299f31d0a4093822),
            (four_words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Philox, PacksGiveTheSameBits) {
  using B = bits_of<pack>;
  const B path([](auto lane) { return 0x123456789ABull + lane; });
  const noise_address a{0xDEADBEEF12345678, noise_kind::area, 0, 0xABCDEF012345};
  const auto packed = random_bits<noise_generator::philox>(counter(a, path, 3), a.seed);
  const auto normal = normal_pair<pack>(a, path, 3);
  for (std::size_t lane = 0; lane < pack::size(); ++lane) {
    const noise_address one{a.seed, a.kind, 0x123456789ABull + lane, a.step};
    const auto words = random_words(one, 3);
    for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(packed[k][lane], words[2 * k] | words[2 * k + 1] << 32);
    for (int k = 0; k < 2; ++k) EXPECT_EQ(normal[k][lane], normal_pair(one, 3)[k]);
  }
}

// The default source, for good: what a seed gave once it gives always.
TEST(Normal, KeepsItsBits) {
  const noise_address a{1, noise_kind::increment, 0, 0},
      b{0xDEADBEEF12345678, noise_kind::area, 0x123456789AB, 0xABCDEF012345};
  EXPECT_EQ(normal_pair(a, 0).c, (std::array{-0x1.d1a253882cf7ap-4, -0x1.d4dbc714217a3p-2}));
  EXPECT_EQ(normal_pair(a, 3).c, (std::array{-0x1.b6ad7966ecb8p-1, 0x1.01621ec5b67fp+0}));
  EXPECT_EQ(normal_pair(b, 0).c, (std::array{-0x1.55d85431dda97p-3, -0x1.d43e2c3a0738dp-1}));
  EXPECT_EQ(normal_pair(b, 3).c, (std::array{-0x1.412fe41bab053p-1, 0x1.424210aa808adp+1}));
}

TEST(Logarithm, IsGoodToTheLastPlace) {
  for (int i = 1; i < 20000; ++i)
    for (const double x : {i * 5e-5, i * 1e-16, 1 - i * 1e-9, i * 1e12}) {
      EXPECT_NEAR(logarithm(x), std::log(x), 2.3e-16 * std::max(std::fabs(std::log(x)), 1e-9)) << x;
      EXPECT_EQ(logarithm(pack(x))[0], logarithm(x));
    }
}

class Source : public testing::TestWithParam<noise_source> {};

TEST_P(Source, EveryFieldOfTheAddressMatters) {
  const noise_address a{1, noise_kind::increment, 5, 9};
  const auto value = [](const noise_address& at, std::uint32_t pair = 0) {
    return normal_pair(at, pair, GetParam()).c;
  };
  const auto here = value(a);
  EXPECT_NE(here[0], here[1]);
  EXPECT_NE(here, value(a, 1));
  EXPECT_NE(here, value({2, a.kind, a.path, a.step}));
  EXPECT_NE(here, value({1ull << 40 | 1, a.kind, a.path, a.step}));
  EXPECT_NE(here, value({a.seed, noise_kind::area, a.path, a.step}));
  EXPECT_NE(here, value({a.seed, a.kind, a.path ^ 1, a.step}));
  EXPECT_NE(here, value({a.seed, a.kind, a.path ^ 2, a.step}));
  EXPECT_NE(here, value({a.seed, a.kind, a.path + (1ull << 40), a.step}));
  EXPECT_NE(here, value({a.seed, a.kind, a.path, a.step + (1ull << 40)}));
}

TEST_P(Source, AskingForFewerChangesNothing) {
  const noise_address a{3, noise_kind::increment, 1, 2};
  const auto all = normals<6>(a, 6, GetParam());
  for (int wanted = 0; wanted <= 6; ++wanted) {
    const auto some = normals<6>(a, wanted, GetParam());
    for (int i = 0; i < 6; ++i) EXPECT_EQ(some[i], i < wanted ? all[i] : 0.0);
  }
}

INSTANTIATE_TEST_SUITE_P(, Source, testing::ValuesIn(test::every_source),
                         [](const auto& source) { return test::name_of(source.param); });

TEST(Uniform, IsNeverZeroOrOne) {
  EXPECT_GT(uniform_of<double>(std::uint64_t{0}), 0.0);
  EXPECT_LT(uniform_of<double>(~std::uint64_t{0}), 1.0);
}

TEST(NoiseAddress, IsThatOfTheFirstIncrementOfTheFirstPathWhereNothingIsSaid) {
  const auto a = noise_address();
  EXPECT_EQ(a.seed, 0u);
  EXPECT_EQ(a.kind, noise_kind::increment);
  EXPECT_EQ(a.path, 0u);
  EXPECT_EQ(a.step, 0u);
}

// Bit by bit: four paths a block, two words each of its halves; a channel a block of its own.
TEST(FastNormal, IsTheQuantileOfItsWord) {
  const noise_source source{noise_generator::philox, noise_quality::fast};
  for (std::uint64_t path = 0; path < 40; ++path)
    for (std::uint32_t channel = 0; channel < 6; ++channel) {
      const noise_address a{5, noise_kind::increment, path, 3};
      const auto halves = random_bits<noise_generator::philox>(
          std::array<std::uint64_t, 2>{3 | std::uint64_t{channel} << 48, path / 4 | 0x8000ull << 48}, a.seed);
      const std::uint64_t words[] = {halves[0] & 0xFFFFFFFF, halves[0] >> 32, halves[1] & 0xFFFFFFFF, halves[1] >> 32};
      const auto word = static_cast<std::uint32_t>(words[path % 4]);
      ASSERT_FALSE(in_tail(word));
      EXPECT_EQ(fast_normal(a, channel), quantile<float>(word)) << path << ' ' << channel;
      EXPECT_EQ(normal_pair(a, channel / 2, source)[channel % 2], quantile<float>(word)) << path << ' ' << channel;
    }
}

TEST(Pairs, OfChannelsAreCounted) {
  for (int channels = 0; channels < 8; ++channels) {
    int pairs = 0;
    for (int i = 0; i < channels; ++i) pairs += i;
    EXPECT_EQ(pairs_among(channels), pairs) << channels;
  }
}

// Chen's relation against the areas of a piecewise linear path computed from their definition.
TEST(Chen, GivesTheAreaOfThePath) {
  std::vector<vec<double, 3>> dw;
  for (std::uint64_t i = 0; i < 17; ++i) dw.push_back(normals<3>({2, noise_kind::increment, 0, i}));
  wiener_levy<double, 3> sum{{1.0, dw[0]}, {}};
  for (std::size_t i = 1; i < dw.size(); ++i) sum = chen(sum, {{1.0, dw[i]}, {}});
  int pair = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = i + 1; j < 3; ++j, ++pair) {
      double wi = 0, wj = 0, area = 0;
      for (const auto& d : dw) {
        area += 0.5 * ((wi + 0.5 * d[i]) * d[j] - (wj + 0.5 * d[j]) * d[i]);
        wi += d[i];
        wj += d[j];
      }
      EXPECT_NEAR(sum.area[pair], area, 1e-12);
      EXPECT_NEAR(sum.dw[i], wi, 1e-12);
    }
  EXPECT_EQ(sum.dt, 17.0);
}

TEST(Chen, IsAssociative) {
  const auto some = [](std::uint64_t i) {
    return wiener_levy<double, 3>{{1.0, normals<3>({2, noise_kind::increment, 1, i})},
                                  normals<3>({2, noise_kind::area, 1, i})};
  };
  const auto left = chen(chen(some(0), some(1)), some(2)), right = chen(some(0), chen(some(1), some(2)));
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(left.area[k], right.area[k], 1e-14);
}

}  // namespace
}  // namespace polhode
