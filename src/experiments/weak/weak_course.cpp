// SPDX-License-Identifier: Apache-2.0
#include "experiments/weak/weak_course.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "experiments/laws/law_errors.hpp"
#include "experiments/weak/true_means.hpp"

namespace polhode {
namespace {

constexpr const char* largest_quantity = "largest error up to T";

Eigen::VectorXd scales_of(const std::vector<error_column>& columns) {
  return Eigen::VectorXd::NullaryExpr(static_cast<Eigen::Index>(columns.size()),
                                      [&](Eigen::Index i) { return columns[static_cast<std::size_t>(i)].scale; });
}

/// The largest divisor of all levels' steps that is not above `most`.
std::int64_t shared_parts(const level_grid& grid, int most) {
  const auto common = std::accumulate(grid.steps.begin(), grid.steps.end(), 0, std::gcd<int, int>);
  int parts = std::max(1, most);
  while (common % parts != 0) --parts;
  return parts;
}

expectation_curve true_curve(const subject& s, const std::vector<sphere_function>& functions,
                             const Eigen::VectorXd& scale, double accuracy) {
  const Eigen::Vector3d start(s.scene.momentum.data());
  if (functions.empty()) return {s.scene.horizon, {}, {}, "no observable's mean is known at the horizon"};
  return expectations(*s.sphere(), functions, scale, start, s.scene.horizon, accuracy);
}

error_table part_of(const error_table& t, Eigen::Index first, Eigen::Index count) {
  error_table out{t.scheme, t.dt, {}, {}, t.taken_back};
  for (std::size_t i = 0; i < t.dt.size(); ++i) {
    out.error.emplace_back(t.error[i].segment(first, count));
    out.uncertainty.emplace_back(t.uncertainty[i].segment(first, count));
  }
  return out;
}

}  // namespace

weak_course::weak_course(const subject& s, const std::vector<error_column>& columns,
                         std::vector<sphere_function> functions, const level_grid& grid, double accuracy)
    : columns_(columns),
      all_(columns),
      functions_(std::move(functions)),
      start_(s.scene.momentum.data()),
      horizon_(s.scene.horizon),
      shared_(shared_parts(grid, most_shared)),
      truth_(true_curve(s, functions_, scales_of(columns), accuracy)) {
  if ((truth_.uncertainty().array() > usable_truth * scales_of(columns).array()).any()) reason_ = truth_.reason();
  all_.push_back({.quantity = largest_quantity, .observable = "all, in their sizes", .scale = 1, .distance = true});
  for (const auto& c : columns)
    for (std::int64_t i = 1; i < shared_; ++i)
      all_.push_back({.quantity = c.quantity,
                      .observable = fmt::format("{} at {} T/{}", c.observable, i, shared_),
                      .scale = c.scale,
                      .limit_alone = true});
}

std::vector<std::int64_t> weak_course::watched(std::int64_t steps) const {
  const std::int64_t part = steps / shared_;
  std::int64_t stride = 1;
  while (part % stride != 0 || steps / stride > most_times) {
    if (stride == part) break;
    ++stride;
  }
  std::vector<std::int64_t> after;
  for (std::int64_t k = stride; k <= steps; k += stride) after.push_back(k);
  return after;
}

transfer_answer weak_course::answer(const subject& s, const scheme_entry& scheme, double dt, std::int64_t steps,
                                    const transfer_target& at_end) const {
  const auto after = watched(steps);
  const auto n = static_cast<Eigen::Index>(columns_.size()), times = static_cast<Eigen::Index>(after.size());
  Eigen::MatrixXd exact(n, times);
  for (Eigen::Index t = 0; t < times; ++t)
    exact.col(t) =
        truth_.at(horizon_ * static_cast<double>(after[static_cast<std::size_t>(t)]) / static_cast<double>(steps));
  exact.col(times - 1) = at_end.exact;
  // From the end on, as that decides.
  const transfer_question q{
      [&](const transfer_operator& op) -> Eigen::VectorXd {
        return means_after(op, start_, functions_, after).rowwise().reverse().reshaped();
      },
      {exact.rowwise().reverse().reshaped(), at_end.scale.replicate(times, 1), at_end.tolerance, n}};
  auto found = refine(s, scheme, dt, steps, q);
  const Eigen::MatrixXd error = found.error.reshaped(n, times).rowwise().reverse(),
                        own = found.uncertainty.reshaped(n, times).rowwise().reverse();
  const Eigen::MatrixXd uncertainty = own.colwise() + truth_.uncertainty();
  Eigen::MatrixXd shared_error(shared_ - 1, n), shared_uncertainty(shared_ - 1, n);
  for (std::int64_t i = 1; i < shared_; ++i) {
    const auto at = times * i / shared_ - 1;
    shared_error.row(i - 1) = error.col(at).transpose();
    shared_uncertainty.row(i - 1) = uncertainty.col(at).transpose();
  }
  const Eigen::VectorXd largest = error.cwiseAbs().rowwise().maxCoeff(), uncertain = uncertainty.rowwise().maxCoeff();
  const auto in_sizes = [&](const Eigen::VectorXd& v) { return (v.array() / at_end.scale.array()).maxCoeff(); };
  found.error.resize(n * (shared_ + 1) + 1);
  found.error << error.col(times - 1), in_sizes(largest), shared_error.reshaped(), largest;
  found.uncertainty.resize(found.error.size());
  found.uncertainty << own.col(times - 1), in_sizes(uncertain), shared_uncertainty.reshaped(), uncertain;
  return found;
}

void weak_course::report(const order_question& horizon, double expected, const error_table& t,
                         std::vector<report::series_id> at_end, recorder& record) const {
  const auto n = static_cast<Eigen::Index>(columns_.size());
  order_question q{horizon.experiment, claim, {all_[columns_.size()]}, horizon.expected};
  auto evidence = std::move(at_end);
  std::ranges::move(report_errors(q, expected, part_of(t, n, 1), record), std::back_inserter(evidence));
  q.columns = columns_;
  for (auto& c : q.columns) {
    c.quantity = largest_quantity;
    c.distance = true;
  }
  std::ranges::move(report_errors(q, expected, part_of(t, t.error.front().size() - n, n), record),
                    std::back_inserter(evidence));
  q.columns = all_;
  record.verdict(claim, judge_table(q, expected, t), evidence);
}

}  // namespace polhode
