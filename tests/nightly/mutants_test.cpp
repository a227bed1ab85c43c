// SPDX-License-Identifier: Apache-2.0
// Every planted defect at every size: who refutes it, and where refutation ends.
#include <gtest/gtest.h>

#include <cstdio>

#include "mutants/score.hpp"

namespace polhode::test {
namespace {

void expect_refuted(const std::vector<row>& rows, int threads) {
  const auto all = run_rows(rows, threads, [](const score& s) {
    std::fputs(line_of(s).c_str(), stdout);
    std::fflush(stdout);
  });
  std::fputs(('\n' + table_text(all) + '\n' + summary_text(all)).c_str(), stdout);
  ASSERT_FALSE(all.defects.empty() || all.twins.empty());
  for (const auto& s : all.twins) {
    EXPECT_GT(s.told, 0) << "nothing is said of healthy " << s.of.scheme << " on " << s.of.scene;
    for (const auto& v : s.refuted)
      ADD_FAILURE() << "healthy " << s.of.scheme << " on " << s.of.scene << ": " << v.claim << ": " << v.reason;
  }
  for (const auto& s : all.defects)
    EXPECT_TRUE(s.refutes() || !s.of.asked)
        << described(s.of.planted) << ", " << s.of.scheme << ", " << s.of.scene << " survives";
}

TEST(MutantsTable, WhatIsAskedForIsRefutedAndNoTwinIs) { expect_refuted(table(), 2); }

// One at a time: a defect of the generator is in force in the whole process.
TEST(MutantsTable, DefectsOfTheGeneratorAreRefuted) { expect_refuted(generator_table(), 1); }

}  // namespace
}  // namespace polhode::test
