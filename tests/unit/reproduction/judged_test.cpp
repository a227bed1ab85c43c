// SPDX-License-Identifier: Apache-2.0
// When does a number agree with a published one?
#include "reproduction/judged.hpp"

#include <gtest/gtest.h>

namespace polhode::test {
namespace {

using report::agreement;

TEST(Judged, AgreesWithAllOfItsIntervalOrNotAtAll) {
  EXPECT_EQ(compared("x", 1, 0.1, {1.05, 1.0, 1.1}, "").verdict, agreement::agrees);
  EXPECT_EQ(compared("x", 1, 0.1, {1.05, 1.0, 1.11}, "").verdict, agreement::differs);
  EXPECT_EQ(compared("x", 1, 0.1, {0.95, 0.89, 1.0}, "").verdict, agreement::differs);
  EXPECT_EQ(compared_at_most("x", 2, {1.9, 1.8, 2.0}, "").verdict, agreement::agrees);
  EXPECT_EQ(compared_at_most("x", 2, {1.9, 1.8, 2.1}, "").verdict, agreement::differs);
  EXPECT_EQ(compared_at_least("x", 2, {2.1, 2.0, 9}, "").verdict, agreement::agrees);
  EXPECT_EQ(compared_at_least("x", 2, {2.1, 1.9, 9}, "").verdict, agreement::differs);
  EXPECT_EQ(compared_between("x", 1, 2, {1.5, 1.0, 2.0}, "").verdict, agreement::agrees);
  EXPECT_EQ(compared_between("x", 1, 2, {1.5, 0.9, 1.9}, "").verdict, agreement::differs);
}

TEST(Judged, NothingThatIsNoNumberAgrees) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(compared("x", 1, 0.1, within(none, 0), "").verdict, agreement::differs);
  EXPECT_EQ(compared_at_most("x", 1, within(none, 0), "").verdict, agreement::differs);
}

TEST(Judged, AReasonIsGivenWhereThereIsADifferenceAlone) {
  const auto same = explained_by(compared("x", 1, 0.1, within(1, 0), "why"), "because");
  EXPECT_EQ(same.verdict, agreement::agrees);
  EXPECT_EQ(same.why, "why");
  const auto other = explained_by(compared("x", 1, 0.1, within(2, 0), "why"), "because");
  EXPECT_EQ(other.verdict, agreement::explained);
  EXPECT_EQ(other.why, "because; why");
}

TEST(Judged, ACaseIsAsGoodAsItsWorstNumber) {
  report::reproduction r;
  EXPECT_EQ(r.verdict(), agreement::agrees);
  r.numbers = {compared("x", 1, 0.1, within(1, 0), ""),
               explained_by(compared("x", 1, 0.1, within(2, 0), ""), "because")};
  EXPECT_EQ(r.verdict(), agreement::explained);
  r.numbers.push_back(compared("x", 1, 0.1, within(2, 0), ""));
  EXPECT_EQ(r.verdict(), agreement::differs);
}

}  // namespace
}  // namespace polhode::test
