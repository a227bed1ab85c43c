#include "experiments/laws/transfer_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "experiments/laws/transfer_refuted.hpp"
#include "statistics/orders/finest_order.hpp"

namespace polhode {
namespace {

using report::verdict;
using report::verdict_kind;

std::vector<double> column_of(const std::vector<Eigen::VectorXd>& rows, std::size_t column) {
  std::vector<double> out;
  for (const auto& row : rows) out.push_back(row[static_cast<Eigen::Index>(column)]);
  return out;
}

/// Of the columns' scales; not finite where an error is not.
double largest_error(const error_table& t, const std::vector<error_column>& columns) {
  double largest = 0;
  for (std::size_t i = 0; i < t.dt.size(); ++i)
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const auto column = static_cast<Eigen::Index>(k);
      const double most = (std::fabs(t.error[i][column]) + t.uncertainty[i][column]) / columns[k].scale;
      largest = std::isfinite(most) ? std::max(largest, most) : most;
    }
  return largest;
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

/// How many paths the claim does not speak of.
std::string rejected(const error_table& t) {
  if (std::ranges::none_of(t.taken_back, [](double share) { return share > 0; })) return "";
  return fmt::format("; of paths near the sphere: all but a share of at most {:.1g} at the finest dt",
                     t.taken_back.back());
}

verdict without_fit(verdict v, double largest) {
  if (!std::isfinite(largest)) {
    v.reason = "not finite: a step of the scheme fails";
  } else if (largest < negligible_error) {
    v.kind = verdict_kind::holds;
    v.reason = fmt::format("no error: at most {:.1e} of the observables' size at every dt", largest);
  } else {
    v.reason = fmt::format("not resolved: fewer than four levels with an error of {:g} times its uncertainty", clear);
  }
  return v;
}

/// Slopes whose last level has gone below what is certain count where they had settled before.
std::vector<std::optional<order_fit>> counting_fits(const std::vector<column_finding>& found) {
  std::vector<std::optional<order_fit>> out;
  for (const auto& f : found) out.push_back(f.fit && (f.fit->settled || f.finest_is_clear) ? f.fit : std::nullopt);
  if (std::ranges::none_of(out, [](const auto& fit) { return fit.has_value(); }))
    std::ranges::transform(found, out.begin(), &column_finding::fit);
  return out;
}

std::string sharpness(const noticed& n) {
  std::string out = "; the limits are zero";
  if (n.noise) out += fmt::format(", noise off by {} would be seen", per_cent(*n.noise));
  if (n.dissipation)
    out += fmt::format("{}dissipation off by {}{}", n.noise ? ", " : ", ", per_cent(*n.dissipation),
                       n.noise ? "" : " would be seen");
  return out;
}

/// A verdict that would hold if the limits are as certain as they have to be.
void ask_for_certainty(verdict& v, const noticed& n) {
  if (v.kind != verdict_kind::holds) return;
  v.reason += sharpness(n);
  if (n.most() <= noticed_share) return;
  v.kind = verdict_kind::inconclusive;
  v.reason += fmt::format(": the limits are not certain enough, {} was to be seen", per_cent(noticed_share));
}

bool has_terms(const column_finding& f) { return !f.terms.empty(); }
bool has_fit(const column_finding& f) { return f.fit.has_value(); }

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

namespace {

/// The slope of what is left above the limit has settled, or nothing is left at the finest level.
bool approaches_its_limit(const error_table& t, std::vector<double> error, std::vector<double> uncertainty,
                          const expansion_term& limit) {
  for (double& e : error) e -= limit.value;
  for (double& u : uncertainty) u += limit.certainty();
  if (std::fabs(error.back()) < clear * uncertainty.back()) return true;
  const auto fit = fit_finest_order(t.dt, error, uncertainty, clear);
  return fit && fit->settled;
}

}  // namespace

std::vector<column_finding> find_columns(const order_question& q, double expected, const error_table& t) {
  std::vector<column_finding> out(q.columns.size());
  for (std::size_t k = 0; k < out.size(); ++k) {
    const auto error = column_of(t.error, k), uncertainty = column_of(t.uncertainty, k);
    if (error.empty()) continue;
    if (!q.columns[k].limit_alone) out[k].fit = fit_finest_order(t.dt, error, uncertainty, clear);
    for (int power = 0; power < std::ceil(expected) && !q.columns[k].distance; ++power) {
      const auto term = series_term_by_best_degree(t.dt, error, uncertainty, power);
      if (!term) break;
      out[k].terms.push_back(*term);
    }
    const double uncertain = uncertainty.back() + (has_terms(out[k]) ? out[k].terms[0].certainty() : 0);
    out[k].finest_is_clear = std::fabs(error.back()) >= clear * uncertain;
    const bool settled = out[k].fit && out[k].fit->settled;
    out[k].approaches = !out[k].finest_is_clear || settled ||
                        (has_terms(out[k]) && approaches_its_limit(t, error, uncertainty, out[k].terms[0]));
  }
  return out;
}

bool too_wide(const order_question& q, double expected, const error_table& t) {
  if (unresolved(t, q.columns)) return false;
  const auto found = find_columns(q, expected, t);
  const auto open = [](const column_finding& f) {
    return !f.approaches || (f.fit && f.finest_is_clear && half_width(*f.fit) > order_margin);  // which decides nothing
  };
  const auto cut_off = [](const column_finding& f) {
    return has_terms(f) && f.terms[0].truncated > f.terms[0].propagated;
  };
  return std::ranges::any_of(found, open) ||
         (noticed_by(q.columns, found).most() > noticed_share && std::ranges::any_of(found, cut_off));
}

verdict judge_columns(const order_question& q, double expected, const std::string& scheme,
                      const std::vector<std::optional<order_fit>>& fits) {
  const claim c{q.experiment, scheme, q.claim};
  const auto severity = [](const verdict& v) {
    return v.kind == verdict_kind::refuted ? 0 : v.kind == verdict_kind::inconclusive ? 1 : 2;
  };
  std::optional<verdict> worst;
  for (std::size_t k = 0; k < fits.size(); ++k) {
    if (!fits[k]) continue;
    auto v = judge_order(c, expected, fits[k], true);
    const auto count = std::ranges::count_if(fits, [](const auto& fit) { return fit.has_value(); });
    v.reason += fmt::format("; {} decides, the slowest of {}", q.columns[k].observable, count);
    if (!worst || std::pair(severity(v), *v.estimate) < std::pair(severity(*worst), *worst->estimate))
      worst = std::move(v);
  }
  return worst ? *worst : judge_order(c, expected, std::nullopt, true);
}

verdict judge_table(const order_question& q, double expected, const error_table& t) {
  const verdict empty{q.experiment, t.scheme, q.claim, expected, {}, {}, {}, verdict_kind::inconclusive, ""};
  const auto found = find_columns(q, expected, t);
  const double largest = largest_error(t, q.columns);
  if (!std::isfinite(largest)) return without_fit(empty, largest);
  if (auto v = rare_branch(empty, q.columns, found, t)) return *v;
  if (auto v = wrong_limit(empty, q.columns, found)) return *v;
  if (auto v = hidden_term(empty, q.columns, found)) return *v;
  if (std::ranges::none_of(found, has_fit)) return without_fit(empty, largest);
  auto v = judge_columns(q, expected, t.scheme, counting_fits(found));
  if (expected > 0) ask_for_certainty(v, noticed_by(q.columns, found));
  v.reason += rejected(t);
  return v;
}

bool unresolved(const error_table& t, const std::vector<error_column>& columns) {
  const double largest = largest_error(t, columns);
  if (!std::isfinite(largest) || largest < negligible_error) return false;
  const auto found = find_columns({{}, {}, columns, {}, {}}, 0, t);
  return std::ranges::none_of(found, has_fit) && !rare_branch({}, columns, found, t);
}

}  // namespace polhode
