// A sample of tests/nightly/references_attack_test.cpp: what takes seconds. Expectations and gaps are attacked there.
#include "support/reference_attack.hpp"

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

}  // namespace
}  // namespace polhode::test
