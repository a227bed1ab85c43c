// SPDX-License-Identifier: Apache-2.0
// A degree that is raised until answers agree.
#include "sphere/galerkin/raise_degree.hpp"

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <vector>

namespace polhode {
namespace {

TEST(RaiseDegree, AgreementByAccidentIsNone) {
  const std::vector<int> degrees{8, 12, 16, 24, 32};
  const auto answer = [&](const std::map<int, double>& values, double needed) {
    return raise_degree(degrees, {.absolute = 1e-9, .size = 1}, needed, [&](int degree) {
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

}  // namespace
}  // namespace polhode
