// The sharpest of the planted defects; all of them in tests/nightly/mutants_test.cpp.
#include <gtest/gtest.h>

#include <cstdio>
#include <ostream>

#include "mutants/score.hpp"

namespace polhode::test {

void PrintTo(const row& r, std::ostream* out) { *out << described(r.planted) << ", " << r.scheme; }

namespace {

struct Mutants : testing::TestWithParam<row> {};

TEST_P(Mutants, AreRefutedAndTheirTwinsAreNot) {
  const auto all = run_rows({GetParam()}, 1);
  std::fputs(table_text(all).c_str(), stdout);
  for (const auto& v : all.twins.front().refuted) ADD_FAILURE() << "the healthy twin: " << v.claim << ": " << v.reason;
  EXPECT_TRUE(all.defects.front().refutes()) << "survives";
}

INSTANTIATE_TEST_SUITE_P(Planted, Mutants, testing::ValuesIn(sharpest()));

}  // namespace
}  // namespace polhode::test
