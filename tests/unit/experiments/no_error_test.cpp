// SPDX-License-Identifier: Apache-2.0
// A scheme whose law errs nowhere: what is not seen has to be negligible where it is certain.
#include <gtest/gtest.h>

#include <cmath>

#include "experiments/laws/transfer_report.hpp"

namespace polhode {
namespace {

/// Of one column, at dt = 1, 1/2, …
error_table table(const std::vector<double>& error, const std::vector<double>& uncertainty) {
  error_table t;
  for (std::size_t i = 0; i < error.size(); ++i) {
    t.dt.push_back(std::ldexp(1.0, -static_cast<int>(i)));
    t.error.emplace_back(Eigen::VectorXd::Constant(1, error[i]));
    t.uncertainty.emplace_back(Eigen::VectorXd::Constant(1, uncertainty[i]));
  }
  return t;
}

report::verdict_kind judged(const std::vector<double>& error, const std::vector<double>& uncertainty) {
  return judge_table({.columns = {{.quantity = "error", .observable = "f"}}}, 1, table(error, uncertainty)).kind;
}

TEST(NoError, HoldsWhereNoneIsSeenAndTheFinerLevelsAreCertain) {
  using enum report::verdict_kind;
  EXPECT_EQ(judged({1e-9, 1e-11, 1e-12, 1e-12, 1e-12}, {4e-9, 1e-10, 1e-10, 1e-10, 1e-10}), holds);
  EXPECT_NE(judged({1e-9, 1e-9, 1e-12, 1e-12, 1e-12}, {4e-9, 4e-9, 1e-10, 1e-10, 1e-10}), holds);  // three are certain
  EXPECT_NE(judged({1e-9, 1e-11, 1e-12, 1e-12, 1e-9}, {4e-9, 1e-10, 1e-10, 1e-10, 4e-9}), holds);  // the finest is not
  EXPECT_NE(judged({6e-9, 1e-11, 1e-12, 1e-12, 1e-12}, {4e-9, 1e-10, 1e-10, 1e-10, 1e-10}), holds);  // one is seen
}

}  // namespace
}  // namespace polhode
