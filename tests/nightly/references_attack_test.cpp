// Thousands of random and extreme scenes against the references: right with an honest bar, or refused.
#include "support/reference_attack.hpp"

namespace polhode::test {
namespace {

int scenes(const char* quantity) {
  const std::map<std::string, int> tried{
      {"gibbs", 20'000}, {"mean", 4000}, {"expectation", 3000}, {"gap", 3000}, {"lyapunov", 400}};
  return tried.at(quantity);
}

class ReferencesUnderAttack : public testing::TestWithParam<const char*> {};

TEST_P(ReferencesUnderAttack, AreHonestOrRefuse) {
  std::mt19937_64 random(20261122);
  std::map<std::string, attack_count> counts;
  for (const bool tame : {true, false}) {
    auto& count = counts[std::string(GetParam()) + (tame ? "" : ", wild")];
    for (int n = 0; n < scenes(GetParam()) / 2; ++n) attack(GetParam(), drawn_scene(random, tame), count);
    EXPECT_LE(count.wrong, 1e-3 * count.checked);
  }
  fmt::print("{}", attack_table(counts));
  EXPECT_GT(counts[GetParam()].answered, counts[GetParam()].tried / 4);
}

INSTANTIATE_TEST_SUITE_P(Quantities, ReferencesUnderAttack,
                         testing::Values("gibbs", "mean", "expectation", "gap", "lyapunov"),
                         [](const auto& chosen) { return std::string(chosen.param); });

}  // namespace
}  // namespace polhode::test
