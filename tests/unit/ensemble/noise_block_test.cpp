// SPDX-License-Identifier: Apache-2.0
// Blocks of normals against the same addresses one by one: every instruction set, source and place.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include <polhode/noise/normal.hpp>

#include "ensemble/kernel.hpp"
#include "ensemble/noise/normal_block.hpp"
#include "platform/isa.hpp"
#include "support/noise_sources.hpp"

namespace polhode {
namespace {

constexpr int rows = 4;
constexpr double scale = 0.3;

class NormalBlock : public testing::TestWithParam<noise_source> {
 protected:
  void SetUp() override {
    if (GetParam().generator == noise_generator::ars && !ars_usable()) GTEST_SKIP() << "no AES instructions";
  }
  void TearDown() override { choose_isa(usable_isas().back()); }

  static std::vector<double> fill(isa level, std::uint64_t path, std::uint64_t step, int steps, int wanted) {
    choose_isa(level);
    std::vector<double> out(static_cast<std::size_t>(steps * rows * block_lanes), -99.0);
    fill_normals({7, noise_kind::area, path, step, steps, rows, wanted, scale, out.data(), GetParam()});
    return out;
  }

  /// The same, one by one.
  static std::vector<double> one_by_one(std::uint64_t path, std::uint64_t step, int steps, int wanted) {
    std::vector<double> out(static_cast<std::size_t>(steps * rows * block_lanes), -99.0);
    for (int s = 0; s < steps; ++s)
      for (int lane = 0; lane < block_lanes; ++lane) {
        const auto v = normals<rows>(
            {7, noise_kind::area, path + static_cast<std::uint64_t>(lane), step + static_cast<std::uint64_t>(s)},
            wanted, GetParam());
        for (int k = 0; k < wanted; ++k)
          out[static_cast<std::size_t>((s * rows + k) * block_lanes + lane)] = scale * v[k];
      }
    return out;
  }

  static bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
  }
};

TEST_P(NormalBlock, IsTheAddressesOneByOne) {
  for (const std::uint64_t path : {0ull, 64ull, 1ull, 1026ull, 4099ull, (1ull << 47) + 16})
    for (const int wanted : {0, 1, 2, 3, 4}) {
      const auto expected = one_by_one(path, (1ull << 33) + 5, 3, wanted);
      for (const isa level : usable_isas())
        EXPECT_TRUE(same_bits(fill(level, path, (1ull << 33) + 5, 3, wanted), expected))
            << name_of(level) << ", path " << path << ", " << wanted << " wanted";
    }
}

// A million values hold some sixteen words of the tail.
TEST_P(NormalBlock, KeepsItsTails) {
  constexpr int steps = 262144 / block_lanes;
  const auto expected = one_by_one(3 * block_lanes, 0, steps, rows);
  const auto far = std::ranges::count_if(expected, [](double x) { return std::fabs(x) > 4.34 * scale; });
  EXPECT_GT(far, 0) << "choose another place: there is no tail here";
  for (const isa level : usable_isas()) EXPECT_TRUE(same_bits(fill(level, 3 * block_lanes, 0, steps, rows), expected));
}

TEST_P(NormalBlock, ValuesDoNotDependOnTheBlock) {
  const auto whole = fill(usable_isas().back(), 0, 0, 8, rows);
  const auto shifted = fill(usable_isas().back(), 5, 3, 5, 2);
  for (int s = 3; s < 8; ++s)
    for (int k = 0; k < 2; ++k)
      for (int lane = 5; lane < block_lanes; ++lane)
        EXPECT_EQ(whole[static_cast<std::size_t>((s * rows + k) * block_lanes + lane)],
                  shifted[static_cast<std::size_t>(((s - 3) * rows + k) * block_lanes + lane - 5)]);
}

// Singles, times the scale in double precision, are the scaled normals.
TEST_P(NormalBlock, SinglesAreTheSameNormals) {
  constexpr int steps = 1024;
  std::vector<float> singles(static_cast<std::size_t>(steps * rows * block_lanes), -99.0F);
  for (const std::uint64_t path : {64ull, 3ull})
    for (const isa level : usable_isas()) {
      const auto scaled = fill(level, path, 5, steps, 3);
      const normal_block request{7,       noise_kind::area, path,          5, steps, rows, 3, scale,
                                 nullptr, GetParam(),       singles.data()};
      if (GetParam().quality == noise_quality::precise) {
        EXPECT_THROW(fill_normals(request), std::invalid_argument);
        continue;
      }
      fill_normals(request);
      std::vector<double> product(singles.size(), -99.0);
      for (std::size_t i = 0; i < singles.size(); ++i)
        if (i / block_lanes % rows < 3) product[i] = scale * double{singles[i]};
      EXPECT_TRUE(same_bits(product, scaled)) << name_of(level) << ", path " << path;
    }
}

INSTANTIATE_TEST_SUITE_P(, NormalBlock, testing::ValuesIn(test::every_source),
                         [](const auto& source) { return test::name_of(source.param); });

TEST(Ars, IsRefusedWithoutTheInstructions) {
  double out[block_lanes];
  const normal_block request{
      1, noise_kind::increment, 0, 0, 1, 1, 1, 1.0, out, {noise_generator::ars, noise_quality::fast}};
  if (ars_usable())
    EXPECT_NO_THROW(fill_normals(request));
  else
    EXPECT_THROW(fill_normals(request), std::invalid_argument);
}

}  // namespace
}  // namespace polhode
