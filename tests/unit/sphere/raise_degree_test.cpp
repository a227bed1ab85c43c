// SPDX-License-Identifier: Apache-2.0
// A degree that is raised until answers agree.
#include "sphere/galerkin/raise_degree.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <optional>
#include <vector>

namespace polhode {
namespace {

const std::vector<int> some_degrees{8, 12, 16, 24, 32};

/// Answers by degree; none where the map has none. `asked_for` remembers the degrees.
struct told {
  std::map<int, projected_value> values;
  std::vector<int> asked_for = {};

  reference_value raised(const accuracy& asked, double needed, int wanted = 0) {
    asked_for.clear();
    const auto at = [this](int degree) {
      asked_for.push_back(degree);
      return values.contains(degree) ? std::optional(values.at(degree)) : std::nullopt;
    };
    return raise_degree(degrees_to_try(some_degrees, wanted), asked, needed, at, wanted);
  }
};

TEST(ThreeAgree, TheLastChangeAndWhatTheOneBeforeAllows) {
  three_agree of;
  EXPECT_EQ(of.uncertainty(unbounded, 1), unbounded);
  EXPECT_EQ(of.uncertainty(0.1, 1), unbounded);
  EXPECT_DOUBLE_EQ(of.uncertainty(0.05, 1), 0.05);                         // half: as a series of halves goes on
  EXPECT_DOUBLE_EQ(of.uncertainty(0.03, 1), 10 * 0.05);                    // does not even halve
  EXPECT_DOUBLE_EQ(of.uncertainty(0.04, 1), 10 * 0.04);                    // grows
  EXPECT_DOUBLE_EQ(of.uncertainty(1e-4, 1), std::pow(0.04, 1.5));          // small by accident
  EXPECT_DOUBLE_EQ(of.uncertainty(1e-9, 4), 4 * std::pow(1e-4 / 4, 1.5));  // in units of the size
  EXPECT_EQ(of.uncertainty(0, 0), 0);
}

TEST(DegreesToTry, TheAutomaticOnesOrTheWantedOneAndTwoLowerOnes) {
  EXPECT_EQ(degrees_to_try(some_degrees, 0), some_degrees);
  EXPECT_EQ(degrees_to_try(some_degrees, 1), (std::vector{1}));
  EXPECT_EQ(degrees_to_try(some_degrees, 2), (std::vector{1, 2}));
  EXPECT_EQ(degrees_to_try(some_degrees, 4), (std::vector{1, 2, 4}));
  EXPECT_EQ(degrees_to_try(some_degrees, 8), (std::vector{4, 6, 8}));
  EXPECT_EQ(degrees_to_try(some_degrees, 40), (std::vector{23, 30, 40}));
}

TEST(NotConverged, SaysWhatWouldBeNeededWhereThatIsFarBeyond) {
  EXPECT_EQ(not_converged(1e-9, 32, 64), "not converged to 1e-09: degree 32 is the last that is affordable");
  EXPECT_EQ(not_converged(1e-9, 32, 1234),
            "not converged to 1e-09: degree 32 is the last that is affordable, and about 1200 would be needed");
  EXPECT_EQ(not_converged(0.002, 1, 17.6),
            "not converged to 0.002: degree 1 is the last that is affordable, and about 18 would be needed");
  EXPECT_EQ(not_converged(0.002, 0, 0), "not converged to 0.002: no affordable degree answers");
}

// Where agreement counts for nothing.
TEST(RaiseDegree, AProvedBoundIsEnough) {
  told of{{{8, {3, 1e-12, 1e-2}}, {12, {2.5, 1e-12, 1e-4}}, {16, {2, 1e-12, 1e-7}}, {24, {2, 1e-12, 1e-9}}}};
  const auto found = of.raised({.absolute = 1e-6}, 1e6);
  EXPECT_TRUE(found.converged());
  EXPECT_EQ(*found.value, 2);
  EXPECT_EQ(found.uncertainty, 1e-7);
  EXPECT_EQ(found.degree, 16);
  EXPECT_EQ(of.asked_for, (std::vector{8, 12, 16}));
  EXPECT_EQ(of.raised({.absolute = 1, .relative = 3.9e-5}, 1e6).degree, 16);  // of a value of 2.5
  EXPECT_EQ(of.raised({.absolute = 1, .relative = 4.1e-5}, 1e6).degree, 12);
  const auto last = of.raised({.absolute = 1e-10, .unit = 100}, 1e6);  // and no more degrees are affordable
  EXPECT_FALSE(last.converged());
  EXPECT_EQ(*last.value, 2);
  EXPECT_EQ(last.uncertainty, 1e-9);
  EXPECT_EQ(last.reason, not_converged(1e-8, 24, 1e6));
}

TEST(RaiseDegree, NothingUndercutsTheFloor) {
  told of{{{8, {3, 1e-5, 1e-8}}, {12, {3, 1e-5, 1e-8}}}};
  const auto found = of.raised({.absolute = 1e-6}, 0);
  EXPECT_TRUE(found.converged());  // as much as rounding leaves
  EXPECT_EQ(found.degree, 8);
  EXPECT_EQ(found.uncertainty, 1e-5);
}

TEST(RaiseDegree, AWantedDegreeIsTheOneThatAnswers) {
  told of{{{9, {1, 0, 0.5}}, {12, {2, 0, 1e-9}}, {16, {3, 0, 1e-10}}}};
  const auto found = of.raised({.absolute = 1e-6}, 0, 16);
  EXPECT_EQ(found.degree, 16);
  EXPECT_EQ(of.asked_for, (std::vector{9, 12, 16}));
}

TEST(RaiseDegree, AgreementCountsFromAShareOfTheNeededDegreeOn) {
  told of{{{8, {1, 0}}, {12, {1 + 1e-5, 0}}, {16, {1, 0}}, {24, {1, 0}}, {32, {1, 0}}}};
  for (auto& [degree, value] : of.values) value.value = 1 + std::pow(10.0, -degree / 2);
  const accuracy asked{.absolute = 1e-5, .size = 1};
  EXPECT_EQ(of.raised(asked, 0).degree, 16);
  EXPECT_EQ(of.raised(asked, 64).degree, 16);
  EXPECT_EQ(of.raised(asked, 65).degree, 24);
  EXPECT_EQ(of.raised(asked, 128).degree, 32);
  of.values[16].resolved = false;
  EXPECT_EQ(of.raised(asked, 0).degree, 24);
  const auto beyond = of.raised(asked, 129);  // no degree counts: a third of them tells whether a bound does
  EXPECT_FALSE(beyond.value);
  EXPECT_EQ(beyond.degree, 12);
  EXPECT_EQ(beyond.uncertainty, 0);
  EXPECT_EQ(beyond.reason, not_converged(1e-5, 32, 129));
  EXPECT_EQ(of.asked_for, (std::vector{8, 12}));
}

TEST(RaiseDegree, EndsAtAnAnswerThatIsNoNumber) {
  told of{{{8, {1, 0, 1}}, {12, {NAN, 0, 1}}, {16, {1, 0, 0}}}};
  const auto found = of.raised({.absolute = 1e-5}, 0);
  EXPECT_EQ(found.degree, 8);
  EXPECT_FALSE(found.converged());
  EXPECT_EQ(*found.value, 1);
  told none{{}};
  EXPECT_FALSE(none.raised({.absolute = 1e-5}, 0).value);
  EXPECT_EQ(none.raised({.absolute = 1e-5, .size = 1}, 0).reason, not_converged(1e-5, 0, 0));
}

TEST(RaiseDegree, AgreementByAccidentIsNone) {
  const auto answer = [&](const std::map<int, double>& values, double needed) {
    return raise_degree(some_degrees, {.absolute = 1e-9, .size = 1}, needed, [&](int degree) {
      return std::optional(projected_value{values.at(degree), 1e-15});
    });
  };
  const auto accident = answer({{8, 1}, {12, 0.9}, {16, 0.9}, {24, 0.8}, {32, 0.75}}, 0);
  EXPECT_FALSE(accident.converged());
  EXPECT_GT(accident.uncertainty, 0.05);
  const auto frozen = answer({{8, 1}, {12, 1}, {16, 1}, {24, 1}, {32, 1}}, 1000);  // nothing is resolved
  EXPECT_FALSE(frozen.value);
  EXPECT_NE(frozen.reason.find("about 1000 would be needed"), std::string::npos) << frozen.reason;
  const auto settled = answer({{8, 1 + 1e-4}, {12, 1 + 1e-7}, {16, 1 + 1e-10}, {24, 1}, {32, 2}}, 30);
  ASSERT_TRUE(settled.converged());
  EXPECT_EQ(settled.degree, 24);
}

TEST(NotConverged, SaysWhichDegreeWouldBeNeeded) {
  EXPECT_EQ(not_converged(1e-3, 12, 24), "not converged to 0.001: degree 12 is the last that is affordable");
  EXPECT_EQ(not_converged(1e-3, 12, 1234),
            "not converged to 0.001: degree 12 is the last that is affordable, and about 1200 would be needed");
  EXPECT_EQ(not_converged(1e-3, 0, 0.3), "not converged to 0.001: no affordable degree answers");
  EXPECT_EQ(not_converged(1e-3, 0, unbounded),
            "not converged to 0.001: no affordable degree answers, and none would do");
  EXPECT_EQ(not_converged(1e-3, 8, NAN), "not converged to 0.001: degree 8 is the last that is affordable");
}

TEST(NotConverged, AFewDegreesAreNamedToo) {
  EXPECT_EQ(not_converged(1e-3, 0, 1.6),
            "not converged to 0.001: no affordable degree answers, and about 2 would be needed");
  EXPECT_EQ(not_converged(1e-3, 12, 30),
            "not converged to 0.001: degree 12 is the last that is affordable, and about 30 would be needed");
}

TEST(RaiseDegree, NamesTheToleranceThatTheLastValueSets) {
  told t{{{8, {5, 0, 1}}, {12, {5, 0, 1}}, {16, {5, 0, 1}}, {24, {5, 0, 1}}, {32, {5, 0, 1}}}};
  EXPECT_EQ(t.raised({.absolute = unbounded, .relative = 0.01}, 0).reason,
            "not converged to 0.05: degree 32 is the last that is affordable");
}

TEST(RaiseDegree, WithoutASizeAgreementSaysNothing) {
  told t{{{8, {5, 0}}, {12, {5, 0}}, {16, {5, 0}}, {24, {5, 0}}, {32, {5, 0}}}};
  EXPECT_FALSE(t.raised({.absolute = 1e-3}, 0).value);
  EXPECT_TRUE(t.raised({.absolute = 1e-3, .size = 1}, 0).converged());
}

}  // namespace
}  // namespace polhode
