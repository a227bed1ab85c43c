// SPDX-License-Identifier: Apache-2.0
#include "experiments/laws/column_findings.hpp"

#include <algorithm>
#include <cmath>

#include "statistics/orders/finest_order.hpp"

namespace polhode {
namespace {

std::vector<double> column_of(const std::vector<Eigen::VectorXd>& rows, std::size_t column) {
  std::vector<double> out;
  for (const auto& row : rows) out.push_back(row[static_cast<Eigen::Index>(column)]);
  return out;
}

/// What a column's value moves by for a share of noise or dissipation, over that share.
using sensitivity = double error_column::*;

double largest_effect(const std::vector<error_column>& columns, sensitivity of) {
  double out = 0;
  for (const auto& c : columns) out = std::max(out, std::fabs(c.*of) / c.scale);
  return out;
}

bool matters(const std::vector<error_column>& columns, sensitivity of) {
  return noticed_share * largest_effect(columns, of) > negligible_error;
}

std::optional<double> noticed_share_of(const std::vector<error_column>& columns,
                                       const std::vector<column_finding>& found, sensitivity of) {
  if (!matters(columns, of)) return std::nullopt;
  const double tolerated = tolerated_limit(columns);
  double least = HUGE_VAL;
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (!found[k].terms.empty())
      least =
          std::min(least, (found[k].terms[0].certainty() + tolerated * columns[k].scale) / std::fabs(columns[k].*of));
  return least;
}

/// The slope of what is left above the limit is asymptotic, or nothing is left at the finest level.
bool approaches_its_limit(const error_table& t, std::vector<double> error, std::vector<double> uncertainty,
                          const expansion_term& limit) {
  for (double& e : error) e -= limit.value;
  for (double& u : uncertainty) u += limit.certainty();
  if (std::fabs(error.back()) < resolved * uncertainty.back()) return true;
  const auto fit = fit_finest_order(t.dt, error, uncertainty, resolved);
  return fit && fit->asymptotic;
}

}  // namespace

double noticed::most() const { return std::max(noise.value_or(0), dissipation.value_or(0)); }

noticed noticed_by(const std::vector<error_column>& columns, const std::vector<column_finding>& found) {
  return {noticed_share_of(columns, found, &error_column::by_noise),
          noticed_share_of(columns, found, &error_column::by_dissipation)};
}

double tolerated_limit(const std::vector<error_column>& columns) {
  double least = HUGE_VAL;
  for (const auto of : {&error_column::by_noise, &error_column::by_dissipation})
    if (matters(columns, of)) least = std::min(least, tolerated_share * largest_effect(columns, of));
  return std::isfinite(least) ? std::max(least, negligible_error) : negligible_error;
}

std::vector<column_finding> find_columns(const order_question& q, double expected, const error_table& t) {
  std::vector<column_finding> out(q.columns.size());
  for (std::size_t k = 0; k < out.size(); ++k) {
    const auto error = column_of(t.error, k), uncertainty = column_of(t.uncertainty, k);
    if (error.empty()) continue;
    if (!q.columns[k].limit_alone) out[k].fit = fit_finest_order(t.dt, error, uncertainty, resolved);
    for (int power = 0; power < std::ceil(expected) && !q.columns[k].distance; ++power) {
      const auto term = series_term_by_best_degree(t.dt, error, uncertainty, power);
      if (!term) break;
      out[k].terms.push_back(*term);
    }
    const double uncertain = uncertainty.back() + (out[k].terms.empty() ? 0 : out[k].terms[0].certainty());
    out[k].finest_is_resolved = std::fabs(error.back()) >= resolved * uncertain;
    const bool asymptotic = out[k].fit && out[k].fit->asymptotic;
    out[k].approaches = !out[k].finest_is_resolved || asymptotic ||
                        (!out[k].terms.empty() && approaches_its_limit(t, error, uncertainty, out[k].terms[0]));
  }
  return out;
}

}  // namespace polhode
