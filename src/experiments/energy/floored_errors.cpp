// SPDX-License-Identifier: Apache-2.0
#include "experiments/energy/floored_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace polhode {
namespace {

double relative_floor(double steps) {
  return 10 * (5e-15 + 0.8 * std::numeric_limits<double>::epsilon() * std::sqrt(steps));
}

/// Too few levels above the floor for a fit. Errors at the floor throughout are exactness on this scene. Else the fall
/// from the coarsest level to another, each known to a tenth of its floor, bounds the order from below.
void judge_at_floor(const floored_errors& e, double expected, report::verdict& v) {
  std::size_t first = e.values.size();  // the first level from which on all is at the floor
  while (first > 0 && e.values[first - 1] <= e.floors[first - 1]) --first;
  const bool exact = std::ranges::equal(e.values, e.most_rounding, std::ranges::less_equal{});
  if (exact) {
    v.kind = report::verdict_kind::holds;
    v.reason = fmt::format("exact on this scene: every error at rounding, below {:.1e}", std::ranges::max(e.values));
    return;
  }
  if (first == e.values.size()) return;
  std::size_t top = 0;  // the coarsest above its floor: a single step has no residual
  while (top + 1 < e.values.size() && e.values[top] <= e.floors[top]) ++top;
  double least = 0;
  for (std::size_t j = top + 1; j <= first && j < e.values.size(); ++j)
    least = std::max(least, std::log2((e.values[top] - e.floors[top] / 10) / (e.values[j] + e.floors[j] / 10)) /
                                static_cast<double>(j - top));
  if (least >= expected - order_margin) v.kind = report::verdict_kind::holds;
  v.low = least;
  v.reason = fmt::format("reaches the rounding floor {:.1e} in {} halvings: order at least {:.2f}", e.floors[first],
                         first - top, least);
}

}  // namespace

floored_errors::floored_errors(const level_grid& grid, std::vector<double> errors, double size)
    : dt(grid.dt()), values(std::move(errors)) {
  for (const int n : grid.steps) {
    floors.push_back(size * relative_floor(n));
    most_rounding.push_back(std::max(floors.back(), size * 8 * std::numeric_limits<double>::epsilon() * n));
  }
}

std::size_t floored_errors::reaches_floor() const {
  std::size_t i = 0;
  while (i < values.size() && values[i] <= floors[i]) ++i;  // a single step has no residual
  while (i < values.size() && !(values[i] <= floors[i])) ++i;
  return i;
}

std::optional<order_fit> floored_errors::fit() const {
  auto above = values;
  for (std::size_t i = 0; i < above.size(); ++i)
    if (above[i] <= 4 * floors[i] || i > reaches_floor()) above[i] = 0;
  return fit_order(dt, above, 0);
}

void report_order(const quantity& what, const std::string& claim, const floored_errors& e, double expected,
                  recorder& record) {
  const auto fit = e.fit();
  curve errors{what};
  for (std::size_t i = 0; i < e.dt.size(); ++i) errors.add(e.dt[i], e.values[i]);
  const auto written = record.series(errors, fit);
  auto v = judge_order(expected, fit, true);
  if (!fit) judge_at_floor(e, expected, v);
  record.verdict(claim, v, {written});
}

}  // namespace polhode
