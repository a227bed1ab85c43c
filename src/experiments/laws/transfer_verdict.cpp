// SPDX-License-Identifier: Apache-2.0
#include "experiments/laws/transfer_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "experiments/laws/transfer_refuted.hpp"

namespace polhode {
namespace {

using report::verdict;
using report::verdict_kind;

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
