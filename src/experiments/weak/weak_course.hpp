// SPDX-License-Identifier: Apache-2.0
// Weak errors at all times up to the horizon: Talay and Tubaro's expansion is uniform on [0, T] (Stoch. Anal. Appl. 8
// (1990) 483), so that sup_n |E[f(X_n)] - E[f(Pi_(n dt))]| falls at the weak order as well. The powers of the scheme's
// operator that lead to the horizon pass all these times.
#pragma once

#include <span>
#include <vector>

#include "experiments/laws/transfer_report.hpp"
#include "sphere/expectations/expectation_curve.hpp"

namespace polhode {

/// Behind the errors at the horizon, one an observable, a table carries the largest of all times and observables, these
/// in their sizes; the errors at some times that all its levels have, observable after observable; and the largest of
/// each observable.
class weak_course {
 public:
  static constexpr std::int64_t most_times = 512;  ///< of more steps as many are looked at, evenly
  static constexpr int most_shared = 8;            ///< times of all levels

  /// At the horizon the errors' columns; accuracy: of the truth at every time, in units of each observable's size.
  weak_course(const subject&, const std::vector<error_column>&, std::vector<sphere_function>, const level_grid&,
              double accuracy);

  /// `at_end` decides how finely an operator is computed; the other times are answered with it.
  transfer_answer answer(const subject&, const scheme_entry&, double dt, std::int64_t steps,
                         const transfer_target& at_end) const;

  /// The largest errors, and the verdict "weak order, uniformly in time": that of `judge_table` with the limits of all
  /// observables at all shared times, the slopes of the horizon's errors and of the largest of all.
  /// at_end: what was written of the horizon's errors.
  void report(const order_question&, double expected, const error_table&, std::vector<report::series_id> at_end,
              recorder&) const;

  /// Of the horizon, and the largest: steps are halved until these are resolved.
  std::vector<error_column> decisive() const { return {all_.begin(), all_.begin() + std::ssize(columns_) + 1}; }

  static constexpr const char* claim = "weak order, uniformly in time";
  /// Why the truth is not known at all times; empty: it is.
  const std::string& reason() const { return reason_; }

 private:
  std::vector<std::int64_t> watched(std::int64_t steps) const;

  std::vector<error_column> columns_, all_;
  std::vector<sphere_function> functions_;
  Eigen::Vector3d start_;
  double horizon_;
  std::int64_t shared_;  ///< equal parts of the horizon, at whose ends all levels have a time
  expectation_curve truth_;
  std::string reason_;
};

}  // namespace polhode
