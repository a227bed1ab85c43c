// SPDX-License-Identifier: Apache-2.0
// Random scenes, every scheme: no healthy scheme is refuted by `modified`.
// POLHODE_SCENES and POLHODE_ATTACK_SEED change how many and which.
#include "support/modified_attack.hpp"

#include <fmt/format.h>

#include <cstdlib>

namespace polhode::test {
namespace {

int from_environment(const char* name, int otherwise) {
  const char* text = std::getenv(name);
  return text ? std::atoi(text) : otherwise;
}

TEST(ModifiedUnderAttack, RefutesNoHealthyScheme) {
  std::mt19937_64 random(static_cast<unsigned>(from_environment("POLHODE_ATTACK_SEED", 20261123)));
  const int scenes = from_environment("POLHODE_SCENES", 40);
  modified_count count;
  for (int n = 0; n < scenes; ++n) attack_modified(random, count);
  fmt::print("{} scenes: {} verdicts hold, {} are inconclusive, {} refuted\n", scenes, count.holding,
             count.inconclusive, count.refuted);
  EXPECT_GT(count.holding, 20 * scenes);
}

}  // namespace
}  // namespace polhode::test
