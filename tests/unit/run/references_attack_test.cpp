// SPDX-License-Identifier: Apache-2.0
// A sample of tests/nightly/references_attack_test.cpp: what takes seconds. Expectations and gaps are attacked there.
#include "support/reference_attack.hpp"

#include <gtest/gtest.h>

namespace polhode::test {
namespace {

void sample(const char* quantity, int scenes) {
  std::mt19937_64 random(18);
  attack_count count;
  for (int n = 0; n < scenes; ++n) attack(quantity, drawn_scene(random, n % 2 == 0), count, true);
  EXPECT_EQ(count.wrong, 0) << attack_table({{quantity, count}});
  EXPECT_GT(count.checked, count.tried / 5) << attack_table({{quantity, count}});
}

TEST(ReferencesUnderAttack, GibbsLaw) { sample("gibbs", 400); }
TEST(ReferencesUnderAttack, StationaryMean) { sample("mean", 40); }

// An attack that could not fail would say nothing: an answer off by a millionth beyond its bar is told wrong.
TEST(ReferencesUnderAttack, TellsAWrongAnswer) {
  const attacked_scene paper{
      body_on_sphere({1, 2, 3}, 0.5, 1, 0.25 * Eigen::Matrix3d::Identity()), {0.6, 0.48, 0.64}, 2, true};
  for (const char* quantity : {"mean", "expectation", "gap", "lyapunov"})
    for (const double off : {0.0, 1e-6}) {
      auto found = asked(quantity, paper, "energy");
      ASSERT_TRUE(found.value);
      const auto seconds = opinions_on(quantity, paper, "energy", found, std::string(quantity) == "expectation");
      *found.value += found.uncertainty * (off > 0) + off * std::fabs(*found.value);
      attack_count count;
      count_answer(count, "planted", paper, found, seconds);
      EXPECT_EQ(count.checked, 1) << quantity;
      EXPECT_EQ(count.wrong, off > 0) << quantity;
    }
}

}  // namespace
}  // namespace polhode::test
