// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "support/normal_statistics.hpp"

namespace polhode {
namespace {

double worst(const std::vector<test::deviation>& found) {
  double z = 0;
  for (const auto& d : found) z = std::max(z, std::fabs(d.z));
  return z;
}

class NormalStatistics : public testing::TestWithParam<noise_source> {};

TEST_P(NormalStatistics, TwentyMillion) {
  if (GetParam().generator == noise_generator::ars && !ars_usable()) GTEST_SKIP() << "no AES instructions";
  const auto found = test::deviations_of_normals(GetParam(), 20'000'000);
  ASSERT_EQ(found.size(), test::tests_a_source);
  for (const auto& [what, z] : found) EXPECT_LT(std::fabs(z), test::family_bound) << what;
}

INSTANTIATE_TEST_SUITE_P(, NormalStatistics, testing::ValuesIn(test::every_source),
                         [](const auto& source) { return test::name_of(source.param); });

// The measure itself: defects it must see.
TEST(NormalStatisticsPower, SeesDefects) {
  const noise_source fast{noise_generator::philox, noise_quality::fast};
  const auto spoiled = [&](auto&& change) {
    return worst(test::deviations_of_normals(fast, 4'000'000, [&](std::vector<double>& x) {
      for (std::size_t i = 0; i + 1 < x.size(); ++i) change(x, i);
    }));
  };
  EXPECT_GT(spoiled([](auto& x, std::size_t i) { x[i] *= 1.003; }), test::family_bound) << "scale";
  EXPECT_GT(spoiled([](auto& x, std::size_t i) { x[i] += 0.003; }), test::family_bound) << "mean";
  EXPECT_GT(spoiled([](auto& x, std::size_t i) { x[i] = std::clamp(x[i], -4.33, 4.33); }), test::family_bound)
      << "tail";
  EXPECT_GT(spoiled([](auto& x, std::size_t i) {
              if (i % 256 == 0) x[i] = x[i + 1];
            }),
            test::family_bound)
      << "a neighbour's value";
  EXPECT_GT(spoiled([](auto& x, std::size_t i) { x[i] = std::round(x[i] * 1000) / 1000; }), test::family_bound)
      << "coarse";
}

}  // namespace
}  // namespace polhode
