// SPDX-License-Identifier: Apache-2.0
// The sharpest of the planted defects; all of them in tests/nightly/mutants_test.cpp.
#include <gtest/gtest.h>

#include <cstdio>

#include "mutants/score.hpp"

namespace polhode::test {
namespace {

TEST(Mutants, AreRefutedByTheExperimentNamedAndTheirTwinsAreNot) {
  const auto all = run_rows(sharpest(), 2);
  std::fputs(table_text(all).c_str(), stdout);
  ASSERT_FALSE(all.defects.empty() || all.twins.empty());
  for (const auto& s : all.twins) {
    EXPECT_GT(s.told, 0) << "nothing is said of healthy " << s.of.scheme << " on " << s.of.scene;
    for (const auto& v : s.refuted)
      ADD_FAILURE() << "healthy " << s.of.scheme << ": " << v.experiment << ": " << v.claim << ": " << v.reason;
  }
  for (const auto& s : all.defects)
    EXPECT_TRUE(s.refutes()) << described(s.of.planted) << ", " << s.of.scheme << ", by " << s.of.experiment;
}

}  // namespace
}  // namespace polhode::test
