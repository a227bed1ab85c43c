// SPDX-License-Identifier: Apache-2.0
// Thousands of random and extreme scenes against the references: right with an honest bar, or refused.
// POLHODE_ATTACK_SCENES and POLHODE_ATTACK_SEED change how many and which.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>

#include "support/from_environment.hpp"
#include "support/reference_attack.hpp"

namespace polhode::test {
namespace {

/// What ends within ten minutes.
int default_scenes(const char* quantity) {
  const std::map<std::string, int> tried{
      {"gibbs", 100'000}, {"mean", 8000}, {"expectation", 600}, {"gap", 2000}, {"lyapunov", 800}};
  return tried.at(quantity);
}

/// Of every second expectation another observable, one after the other.
std::string observable(const std::string& quantity, int n) {
  const std::array others{"pi1", "pi2", "pi3", "pi1^2", "exp(pi3)"};
  return quantity != "expectation" || n % 2 == 0 ? "energy" : others[static_cast<std::size_t>(n) / 2 % others.size()];
}

class ReferencesUnderAttack : public testing::TestWithParam<const char*> {};

TEST_P(ReferencesUnderAttack, AreHonestOrRefuse) {
  std::mt19937_64 random(static_cast<unsigned>(from_environment("POLHODE_ATTACK_SEED", 20261122)));
  std::map<std::string, attack_count> counts;
  const int tried = from_environment("POLHODE_ATTACK_SCENES", default_scenes(GetParam()));
  for (const bool tame : {true, false}) {
    auto& count = counts[std::string(GetParam()) + (tame ? "" : ", wild")];
    for (int n = 0; n < tried / 2; ++n)
      attack(GetParam(), drawn_scene(random, tame), count, n % 8 < 2, observable(GetParam(), n));
    EXPECT_LE(count.wrong, 1e-3 * count.checked);
  }
  fmt::print("{}", attack_table(counts));
  EXPECT_GT(counts[GetParam()].answered, counts[GetParam()].tried / 4);
  EXPECT_GT(counts[GetParam()].checked, 0);
}

INSTANTIATE_TEST_SUITE_P(Quantities, ReferencesUnderAttack,
                         testing::Values("gibbs", "mean", "expectation", "gap", "lyapunov"),
                         [](const auto& chosen) { return std::string(chosen.param); });

}  // namespace
}  // namespace polhode::test
