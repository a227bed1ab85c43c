// SPDX-License-Identifier: Apache-2.0
#include "experiments/laws/transfer_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

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

// What refutes the order of a scheme whose errors carry no sampling error, besides their slope: each the worst column's
// word, with a reason, or nothing. `empty` is the verdict without a finding.

/// "0.01 %" of a share.
std::string per_cent(double share) { return fmt::format("{:.2g} %", 100 * share); }

/// "as noise off by 0.1 %": which change of noise or dissipation would leave that limit in that column.
std::string equivalent(const error_column& c, double limit) {
  std::string out;
  for (const auto& [name, moved] : {std::pair{"noise", c.by_noise}, std::pair{"dissipation", c.by_dissipation}})
    if (const double share = std::fabs(limit / moved); share < 1)
      out += fmt::format("{} {} off by {}", out.empty() ? ", as" : " or", name, per_cent(share));
  return out;
}

verdict refuted(verdict v, const column_finding& found, std::string reason) {
  v.kind = verdict_kind::refuted;
  v.reason = std::move(reason);
  if (found.fit) {
    v.estimate = found.fit->order;
    v.low = found.fit->low;
    v.high = found.fit->high;
  }
  return v;
}

/// A limit other than zero, in the column where it stands out most.
std::optional<verdict> wrong_limit(const verdict& empty, const std::vector<error_column>& columns,
                                   const std::vector<column_finding>& found) {
  const double tolerated = tolerated_limit(columns);
  std::optional<std::size_t> worst;
  double most = 1;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (found[k].terms.empty()) continue;
    const auto& limit = found[k].terms[0];
    const double out = std::fabs(limit.value) / (limit.certainty() + tolerated * columns[k].scale);
    if (out > most) {
      worst = k;
      most = out;
    }
  }
  if (!worst) return std::nullopt;
  const auto& limit = found[*worst].terms[0];
  return refuted(
      empty, found[*worst],
      fmt::format("wrong limit: at dt = 0 {} is left with an error of {:.3g} +- {:.1g}{}", columns[*worst].observable,
                  limit.value, limit.certainty(), equivalent(columns[*worst], limit.value)));
}

/// A term below the claimed order, in the column where it stands out most. Twice the certainty, as nothing else sets a
/// scale for it.
std::optional<verdict> hidden_term(const verdict& empty, const std::vector<error_column>& columns,
                                   const std::vector<column_finding>& found) {
  std::optional<std::pair<std::size_t, std::size_t>> worst;
  double most = 2;
  for (std::size_t k = 0; k < columns.size(); ++k)
    for (std::size_t power = 1; power < found[k].terms.size(); ++power) {
      const auto& term = found[k].terms[power];
      if (const double out = std::fabs(term.value) / term.certainty(); out > most) {
        worst = {k, power};
        most = out;
      }
    }
  if (!worst) return std::nullopt;
  const auto& [k, power] = *worst;
  const auto& term = found[k].terms[power];
  return refuted(empty, found[k],
                 fmt::format("{} has a term of order {}: {:.3g} +- {:.1g} times dt^{}", columns[k].observable, power,
                             term.value, term.certainty(), power));
}

/// A step that is not smooth in its increment: its law is not what the quadrature over few nodes makes of it. More
/// than what the loss of rare_share of the noise moves; where that moves nothing, three times the level's uncertainty.
std::optional<verdict> rare_branch(const verdict& empty, const std::vector<error_column>& columns,
                                   const std::vector<column_finding>& found, const error_table& t) {
  double noise = 0;
  for (const auto& c : columns) noise = std::max(noise, t.far_noise.share * std::fabs(c.by_noise) / c.scale);
  const auto level = std::ranges::find(t.dt, t.far_noise.dt) - t.dt.begin();
  const double tolerated = tolerated_limit(columns);
  std::optional<std::size_t> worst;
  double most = 1;
  for (Eigen::Index k = 0; k < t.far_noise.change.size(); ++k) {
    const double scale = columns[static_cast<std::size_t>(k)].scale;
    const double allowed = noise > negligible_error
                               ? noise * scale
                               : 3 * t.uncertainty[static_cast<std::size_t>(level)][k] + tolerated * scale;
    if (const double out = t.far_noise.change[k] / allowed; out > most) {
      worst = static_cast<std::size_t>(k);
      most = out;
    }
  }
  if (!worst) return std::nullopt;
  return refuted(
      empty, found[*worst],
      fmt::format("not smooth in its noise: increments out to 8 sqrt(dt) move {} at dt = {:.3g} by {:.2g}, "
                  "so rare ones take another branch of the step",
                  columns[*worst].observable, t.far_noise.dt, t.far_noise.change[static_cast<Eigen::Index>(*worst)]));
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

/// Of errors that are seen at no level: the largest that there may be at the levels that are certain, the finest and at
/// least so many as a fit takes; nothing where an error is seen or fewer are certain.
std::optional<double> bound_on_no_error(const error_table& t, const std::vector<error_column>& columns) {
  constexpr int needed = 4;
  double largest = 0;
  int certain = 0;
  for (std::size_t i = 0; i < t.dt.size(); ++i) {
    double most = 0;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const auto column = static_cast<Eigen::Index>(k);
      const double error = std::fabs(t.error[i][column]), bar = t.uncertainty[i][column];
      if (!(error <= (columns[k].distance ? 2 : 1) * bar))
        return std::nullopt;  // no distance is below what is uncertain
      most = std::max(most, (error + bar) / columns[k].scale);
    }
    certain = most < negligible_error ? certain + 1 : 0;
    largest = certain > 0 ? std::max(largest, most) : 0;
  }
  return certain >= needed ? std::optional(largest) : std::nullopt;
}

/// How many paths the claim does not speak of.
std::string rejected(const error_table& t) {
  if (std::ranges::none_of(t.taken_back, [](double share) { return share > 0; })) return "";
  return fmt::format("; of paths near the sphere: all but a share of at most {:.1g} at the finest dt",
                     t.taken_back.back());
}

verdict without_fit(verdict v, double largest, std::optional<double> unseen) {
  if (!std::isfinite(largest)) {
    v.reason = "not finite: a step of the scheme fails";
  } else if (unseen) {
    v.kind = verdict_kind::holds;
    v.reason =
        fmt::format("no error is seen at any dt: at most {:.1e} of the observables' size at the finer ones", *unseen);
  } else if (largest < negligible_error) {
    v.kind = verdict_kind::holds;
    v.reason = fmt::format("no error: at most {:.1e} of the observables' size at every dt", largest);
  } else {
    v.reason =
        fmt::format("not resolved: fewer than four levels with an error of {:g} times its uncertainty", resolved);
  }
  return v;
}

/// Slopes whose last level has gone below what is certain count where they were asymptotic before.
std::vector<std::optional<order_fit>> counting_fits(const std::vector<column_finding>& found) {
  std::vector<std::optional<order_fit>> out;
  for (const auto& f : found)
    out.push_back(f.fit && (f.fit->asymptotic || f.finest_is_resolved) ? f.fit : std::nullopt);
  if (std::ranges::none_of(out, [](const auto& fit) { return fit.has_value(); }))
    std::ranges::transform(found, out.begin(), &column_finding::fit);
  return out;
}

std::string sharpness(const noticed& n) {
  std::string out = "; the limits are zero";
  if (n.noise) out += fmt::format(", noise off by {} would be seen", per_cent(*n.noise));
  if (n.dissipation)
    out += fmt::format(", dissipation off by {}{}", per_cent(*n.dissipation), n.noise ? "" : " would be seen");
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

bool too_wide(const order_question& q, double expected, const error_table& t) {
  if (unresolved(t, q.columns)) return false;
  const auto found = find_columns(q, expected, t);
  const auto open = [](const column_finding& f) {
    return !f.approaches ||
           (f.fit && f.finest_is_resolved && half_width(*f.fit) > order_margin);  // which decides nothing
  };
  const auto cut_off = [](const column_finding& f) {
    return !f.terms.empty() && f.terms[0].truncated > f.terms[0].propagated;
  };
  return std::ranges::any_of(found, open) ||
         (noticed_by(q.columns, found).most() > noticed_share && std::ranges::any_of(found, cut_off));
}

verdict judge_columns(const order_question& q, double expected, const std::vector<std::optional<order_fit>>& fits) {
  const auto severity = [](const verdict& v) {
    return v.kind == verdict_kind::refuted ? 0 : v.kind == verdict_kind::inconclusive ? 1 : 2;
  };
  std::optional<verdict> worst;
  for (std::size_t k = 0; k < fits.size(); ++k) {
    if (!fits[k]) continue;
    auto v = judge_order(expected, fits[k], true);
    const auto count = std::ranges::count_if(fits, [](const auto& fit) { return fit.has_value(); });
    v.reason += fmt::format("; {} decides, the slowest of {}", q.columns[k].observable, count);
    if (!worst || std::pair(severity(v), *v.estimate) < std::pair(severity(*worst), *worst->estimate))
      worst = std::move(v);
  }
  return worst ? *worst : judge_order(expected, std::nullopt, true);
}

verdict judge_table(const order_question& q, double expected, const error_table& t) {
  const verdict empty{.expected = expected};
  const auto found = find_columns(q, expected, t);
  const double largest = largest_error(t, q.columns);
  if (!std::isfinite(largest)) return without_fit(empty, largest, std::nullopt);
  if (auto v = rare_branch(empty, q.columns, found, t)) return *v;
  if (auto v = wrong_limit(empty, q.columns, found)) return *v;
  if (auto v = hidden_term(empty, q.columns, found)) return *v;
  if (std::ranges::none_of(found, has_fit)) return without_fit(empty, largest, bound_on_no_error(t, q.columns));
  auto v = judge_columns(q, expected, counting_fits(found));
  if (expected > 0) ask_for_certainty(v, noticed_by(q.columns, found));
  v.reason += rejected(t);
  return v;
}

bool unresolved(const error_table& t, const std::vector<error_column>& columns) {
  const double largest = largest_error(t, columns);
  if (!std::isfinite(largest) || largest < negligible_error || bound_on_no_error(t, columns)) return false;
  const auto found = find_columns({.columns = columns}, 0, t);
  return std::ranges::none_of(found, has_fit) && !rare_branch({}, columns, found, t);
}

}  // namespace polhode
