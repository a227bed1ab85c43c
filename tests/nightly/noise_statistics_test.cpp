// SPDX-License-Identifier: Apache-2.0
// Two billion normals of every source, by the measure of tests/unit/ensemble/noise_statistics_test.cpp.
#include <gtest/gtest.h>

#include "support/normal_statistics.hpp"

namespace polhode {
namespace {

class NormalStatistics : public testing::TestWithParam<noise_source> {};

TEST_P(NormalStatistics, TwoBillion) {
  if (GetParam().generator == noise_generator::ars && !ars_usable()) GTEST_SKIP() << "no AES instructions";
  const auto found = test::deviations_of_normals(GetParam(), 2'000'000'000);
  ASSERT_EQ(found.size(), test::tests_a_source);
  for (const auto& [what, z] : found) {
    EXPECT_LT(std::fabs(z), test::family_bound) << what;
    RecordProperty(what, std::to_string(z));
  }
}

INSTANTIATE_TEST_SUITE_P(, NormalStatistics, testing::ValuesIn(test::every_source),
                         [](const auto& source) { return test::name_of(source.param); });

}  // namespace
}  // namespace polhode
