// SPDX-License-Identifier: Apache-2.0
#include "experiments/stability/mean_square_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/common/judge.hpp"
#include "experiments/common/levels.hpp"
#include "experiments/stability/mean_square.hpp"
#include "statistics/orders/order_fit.hpp"

namespace polhode {
namespace {

using report::verdict_kind;

constexpr int levels = 12;         // of the order: dt times the fastest rate from 1/4, halved
constexpr double neutral = 1e-11;  // rate of growth over the fastest rate: neither stable nor unstable
constexpr double longest = 8;      // dt times the fastest rate, from where agreement is looked for
constexpr int per_octave = 8;
constexpr const char* growth_quantity = "mean_square_growth";

/// One equilibrium of one scheme.
struct growth_finding {
  noisy_equilibrium at;
  double truth;
  std::optional<order_fit> fit;
  bool exact;                              ///< every error at rounding
  double agrees_to = 0, disagrees_at = 0;  ///< dt; 0: never
  std::vector<report::series_id> rows = {};
};

/// From short steps to long ones, up to the first at which scheme and equation disagree.
void find_agreement(const subject& s, const scheme_entry& scheme, double rate, growth_finding& out) {
  if (std::fabs(out.truth) <= neutral * rate) return;
  for (int i = 5 * per_octave; i >= 0; --i) {
    const double dt = longest / rate * std::exp2(-static_cast<double>(i) / per_octave);
    const double own = own_mean_square_growth(s, scheme, out.at.direction, dt);
    if (!(own * out.truth > 0)) {
      out.disagrees_at = dt;
      return;
    }
    out.agrees_to = dt;
  }
}

/// What rounding leaves of a rate: the logarithm of a radius known to some 16 units over dt.
double rounding_at(double dt) { return 16 * std::numeric_limits<double>::epsilon() / dt; }

/// Thirty times that, so that it does not bend a slope.
double floor_at(double dt) { return 30 * rounding_at(dt); }

growth_finding find(const subject& s, const scheme_entry& scheme, const noisy_equilibrium& e, recorder& record) {
  const double rate = fastest_rate(s);
  growth_finding found{e, true_mean_square_growth(*s.sphere(), e), {}, true};
  curve growth{{growth_quantity, e.name, "1/time", "transfer"}},
      error{{"mean_square_error", e.name, "1/time", "transfer"}};
  std::vector<double> dt, errors;
  for (int l = 0; l < levels; ++l) {
    dt.push_back(std::exp2(-2 - l) / rate);
    const double own = own_mean_square_growth(s, scheme, e.direction, dt.back());
    errors.push_back(std::fabs(own - found.truth));
    const double size = errors.back(), rounding = rounding_at(dt.back());
    growth.add(dt.back(), own, own - rounding, own + rounding);
    error.add(dt.back(), size, std::max(0.0, size - rounding), size + rounding);
    if (size <= floor_at(dt.back()))
      errors.back() = 0;
    else
      found.exact = false;
  }
  found.fit = fit_order(dt, errors, 0);
  found.rows = {record.series(growth), record.series(error, found.fit)};
  find_agreement(s, scheme, rate, found);
  if (found.agrees_to > 0)
    found.rows.push_back(record.value({"mean_square_agreement", e.name, "time", "transfer"}, found.agrees_to,
                                      found.agrees_to,
                                      found.disagrees_at > 0 ? std::optional(found.disagrees_at) : std::nullopt));
  return found;
}

report::verdict judge_growth(const scheme_entry& scheme, const growth_finding& f) {
  auto v = judge_order(scheme.info.weak_order.one_vector, f.fit, true);
  if (f.exact) {
    v.kind = verdict_kind::holds;
    v.reason = "exact on this scene";
  }
  v.reason = fmt::format("{}: rate {:.4g}, {}", f.at.name, f.truth, v.reason);
  if (f.agrees_to > 0)
    v.reason += fmt::format(", {} up to dt = {:.3g}", f.truth < 0 ? "stable" : "unstable", f.agrees_to);
  return v;
}

/// The worst of them, with what is said of each.
report::verdict worst_of(const std::vector<report::verdict>& all) {
  const auto badness = [](const report::verdict& v) {
    return v.kind == verdict_kind::refuted ? 2 : v.kind == verdict_kind::inconclusive ? 1 : 0;
  };
  auto worst = *std::ranges::max_element(all, {}, badness);
  std::vector<std::string> reasons;
  for (const auto& v : all) reasons.push_back(v.reason);
  worst.reason = fmt::format("{}", fmt::join(reasons, "; "));
  return worst;
}

}  // namespace

void report_true_growth(const subject& s, recorder& record) {
  for (const auto& e : noisy_equilibria(s))
    record.value({growth_quantity, e.name, "1/time", "exact"}, true_mean_square_growth(*s.sphere(), e));
}

void report_mean_square(const context& c, recorder& record) {
  std::vector<report::verdict> all;
  std::vector<report::series_id> evidence;
  for (const auto& e : noisy_equilibria(c.subject)) {
    const auto s = c.subject.with(beside(c.subject.scene, e));
    const auto& scheme =
        *std::ranges::find(s.schemes, record.scheme(), [](const scheme_entry& x) { return x.info.name; });
    const auto found = find(s, scheme, e, record);
    all.push_back(judge_growth(scheme, found));
    evidence.insert(evidence.end(), found.rows.begin(), found.rows.end());
  }
  if (!all.empty()) record.verdict("growth of mean squares at the equilibria", worst_of(all), evidence);
}

}  // namespace polhode
