// Hundreds of random scenes, every scheme: no healthy scheme is refuted by `modified`.
#include "support/modified_attack.hpp"

#include <cstdlib>

namespace polhode::test {
namespace {

/// Two hundred, or as the environment says (POLHODE_SCENES).
int scenes() {
  const char* wanted = std::getenv("POLHODE_SCENES");
  return wanted ? std::atoi(wanted) : 200;
}

TEST(ModifiedUnderAttack, RefutesNoHealthyScheme) {
  std::mt19937_64 random(20261123);
  int holding = 0;
  for (int n = 0; n < scenes(); ++n) holding += attack_modified(random, true);
  EXPECT_GT(holding, 20 * scenes());
}

}  // namespace
}  // namespace polhode::test
