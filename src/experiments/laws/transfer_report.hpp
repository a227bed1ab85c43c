// SPDX-License-Identifier: Apache-2.0
// Errors that carry no sampling error, over several step sizes: measurements, fits and one verdict.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "experiments/common/experiment.hpp"
#include "experiments/common/judge.hpp"
#include "experiments/common/levels.hpp"
#include "experiments/common/recorder.hpp"
#include "transfer/transfer_refine.hpp"

namespace polhode {

/// The scheme's claimed weak order on this noise.
double weak_order_on(const scheme_info&, noise_class);

/// The root of the mean square of f over the sphere: the unit of its errors.
double size_on_sphere(const sphere_function&, double radius);

/// [level] of one scheme; errors and uncertainties [quantity].
struct error_table {
  std::string scheme;
  std::vector<double> dt;
  std::vector<Eigen::VectorXd> error, uncertainty;
  std::vector<double> taken_back{};  ///< transfer_answer::taken_back, of levels that were asked
  struct far {
    double dt = 0, share = 0;  ///< share: of the noise, that may go far out unnoticed (noise_nodes.hpp)
    Eigen::VectorXd change{};
  } far_noise{};  ///< what noise far out changes at one level; no change: not asked

  void add(double step, const transfer_answer&);
};

/// What is reported of column i, and by how much its truth changes when the noise (the dissipation) grows by a share,
/// over that share: by s d/ds of it, s their strength. 0: not known, or it does not change.
struct error_column {
  std::string quantity, observable;
  double scale = 1;
  double by_noise = 0, by_dissipation = 0;
  bool distance = false;     ///< never negative, so no power series where it vanishes: its limit is not asked for
  bool limit_alone = false;  ///< its slope is not asked for
};

/// The share by which noise and dissipation grow to tell by_noise and by_dissipation: to about as much of them.
inline constexpr double sensitivity_share = 0.01;

/// What every scheme is asked at every level, and the order it claims.
struct order_question {
  std::string experiment = {}, claim = {};
  std::vector<error_column> columns = {};
  std::function<double(const scheme_entry&)> expected = {};
  std::function<transfer_answer(const scheme_entry&, double dt, std::int64_t steps)> answer = {};
  /// change_by_far_noise of the columns; empty: not asked.
  std::function<Eigen::VectorXd(const scheme_entry&, double dt, std::int64_t steps)> far_noise = {};
};

/// Answers of every scheme at every level, in parallel; the same for any number of threads. While the intervals of a
/// scheme are too wide for a verdict (transfer_verdict.hpp) its step is halved on, most_halvings times at most. Noise
/// far out is asked for at the finest level of the grid.
std::vector<error_table> answer_all(const context&, const std::vector<scheme_entry>&, const level_grid&,
                                    const order_question&);
inline constexpr int most_halvings = 6;

/// For each column a measurement a level (its interval: the uncertainty), a fit over its finest resolved levels, and
/// the terms of its series below the order that is expected: the error at dt = 0 first. What was written.
std::vector<report::series_id> report_errors(const order_question&, double expected, const error_table&, recorder&);

/// Measurements of what the operators leave out: the share of paths taken back to the shell at each level, and what
/// noise far out changes. What was written.
std::vector<report::series_id> report_reach(const order_question&, const error_table&, recorder&);

/// All of them, and the verdict on the order. What it rests on.
std::vector<report::series_id> report_orders(const order_question&, double expected, const error_table&, recorder&);

/// The verdict alone (transfer_verdict.hpp). The slowest column decides; an order above the claim holds once the slope
/// is asymptotic. Where no column has four resolved levels, the claim holds if all errors are negligible, or if none is
/// seen at any level and all that are possible at the four finest and before are negligible; else nothing is concluded.
report::verdict judge_table(const order_question&, double expected, const error_table&);

/// The verdict on fits of the question's columns, where a column has one: the worst, and of these the slowest.
report::verdict judge_columns(const order_question&, double expected, const std::vector<std::optional<order_fit>>&);

/// Are all errors finite, not negligible, and yet too uncertain for an order?
bool unresolved(const error_table&, const std::vector<error_column>&);

}  // namespace polhode
