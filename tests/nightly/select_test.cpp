// SPDX-License-Identifier: Apache-2.0
// A hundred random scenes and four goals: what `select` chooses meets the target for every observable, at the step and
// below it, when it is measured in another way.
#include "support/selection_check.hpp"

#include <gtest/gtest.h>

#include "support/from_environment.hpp"

namespace polhode {
namespace {

using namespace test;

/// POLHODE_SCENES: another number.
int scenes() { return from_environment("POLHODE_SCENES", 100); }

class EveryTarget : public testing::TestWithParam<std::pair<const char*, double>> {};

TEST_P(EveryTarget, IsMetOnEveryScene) {
  ASSERT_GT(scenes(), 0);
  std::mt19937_64 random(17);
  for (int i = 0; i < scenes(); ++i) {
    const auto s = random_scene(random, i);
    const auto o = asking(GetParam().first, GetParam().second);
    const auto found = select(s, o);
    ASSERT_TRUE(found.winner) << s.name << ' ' << o.goal << ": " << found.reason;
    const double error = measured_again(s, o, *found.winner);
    EXPECT_LE(error, o.tolerance) << s.name << ' ' << o.goal << ": " << found.winner->scheme
                                  << " at dt = " << found.winner->dt;
  }
}

INSTANTIATE_TEST_SUITE_P(Select, EveryTarget,
                         testing::Values(std::pair{"weak", 1e-4}, std::pair{"stationary", 1e-4},
                                         std::pair{"energy", 1e-5}, std::pair{"strong", 3e-2}),
                         [](const auto& goal) { return std::string(goal.param.first); });

}  // namespace
}  // namespace polhode
