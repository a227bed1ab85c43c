// SPDX-License-Identifier: Apache-2.0
// The errors of schemes' laws at the horizon and at all times up to it, on one grid of steps, and what is said of them.
#pragma once

#include <vector>

#include "experiments/weak/true_means.hpp"
#include "experiments/weak/weak_course.hpp"

namespace polhode {

/// Every scheme's errors on one grid of steps.
class weak_tables {
 public:
  weak_tables(const context&, const true_means&, std::vector<scheme_entry>, level_grid);
  weak_tables(const weak_tables&) = delete;
  weak_tables& operator=(const weak_tables&) = delete;

  /// All but the schemes that are not resolved, which it returns.
  std::vector<scheme_entry> report(const subject&, report::results& out) const;

  order_question question(const subject&) const;

  const std::vector<scheme_entry> schemes;

 private:
  void report_one(const subject&, const scheme_entry&, const error_table&, report::results& out) const;
  void report_extrapolations(const order_question&, const error_table&, double horizon, report::results& out) const;
  void report_cost(const error_table&, double horizon, double order, double runs, recorder&) const;

  const true_means& known_;
  level_grid grid_;
  weak_course course_;
  std::vector<error_table> tables_;
};

}  // namespace polhode
