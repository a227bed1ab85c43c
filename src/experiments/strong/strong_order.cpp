// SPDX-License-Identifier: Apache-2.0
#include "experiments/strong/strong_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/common/judge.hpp"
#include "problem/vectors.hpp"
#include "statistics/noise/area_strength.hpp"

namespace polhode {
namespace {

constexpr double tight_leading = 0.1;  // of the mean square error: half-width of its part of the claimed order

const quantity error_quantity{"error", "state", "|mu|", "sampled"};

quantity strength_of(const std::string& what) { return {"strength of " + what, "", "", "sampled"}; }

const quantity area_quantity = strength_of("Levy areas");

/// A slope above the claim: weak noise can hide the term of the claimed order under a larger one of higher order. If
/// that term is there the claim is right, and only the range of dt is kind; if it cannot be seen, nothing is decided.
void judge_hidden_order(const interval_estimate& leading, double claimed, const order_fit& fit, report::verdict& v) {
  const bool seen = leading.low > 0;
  v.kind = seen ? report::verdict_kind::holds : report::verdict_kind::inconclusive;
  v.reason = fmt::format(
      "order {:.3f} [{:.3f}, {:.3f}] at these dt, above the claimed {:g}: the noise is weak. Mean square error "
      "~ {:.2e} [{:.2e}, {:.2e}] dt^{:g} + …: the term of the claimed order is {}",
      fit.order, fit.low, fit.high, claimed, leading.value, leading.low, leading.high, 2 * claimed,
      seen ? "there" : "not seen");
}

/// Areas felt too strongly or too weakly leave a term of order 1/2, however small beside the scheme's own error.
void judge_areas(const multiplier& areas, report::verdict& v) {
  const auto& e = areas.error;
  v.reason += fmt::format("; Levy areas are felt {:.4f} [{:.4f}, {:.4f}] times", 1 + e.value, 1 + e.low, 1 + e.high);
  if (std::fabs(e.value) <= areas.sure) return;  // as it is for healthy schemes, but for a chance of 1e-7
  v.kind = report::verdict_kind::refuted;
  v.reason += ": a term of order 1/2 is left";
}

report::series_id record_strength(const quantity& what, const multiplier& m, recorder& record) {
  return record.value(what, 1 + m.error.value, 1 + m.error.low, 1 + m.error.high);
}

}  // namespace

double strong_question::claimed() const { return strong_order_on(scheme.info, c.subject.model->noise()); }

strong_finding find_order(const strong_question& q, const path_record& paths, const noise_effect& noise) {
  const double claimed = q.claimed();
  strong_finding f{fit_order(q.dt, paths.error, 1e-13 * length(q.c.subject.scene.momentum), q.c.seed), {}, {}, {}};
  if (claimed > 0.5) f.areas = area_strength(q.dt, paths.areas, paths.error.paths, fine_per_step);
  f.limit = limit_of(q.c, q.scheme.info, q.dt, paths, noise, fine_per_step);
  if (!f.fit) return f;
  // What hides the term of the claimed order is its cross term with the next and the square of that.
  const int powers = f.fit->order > claimed + order_margin ? 3 : 2;
  f.leading = fit_error_model(q.dt, paths.error, f.fit->used, claimed, q.c.seed, powers).leading;
  return f;
}

bool tight(const strong_question& q, const squared_errors& errors, const strong_finding& f) {
  if (!f.fit) return true;
  const double unit = level_mean(errors, errors.levels - 1).mean / std::pow(q.dt.back(), 2 * q.claimed());
  return half_width(*f.fit) <= tight_order && tight(f.limit) && half_width(f.leading) <= tight_leading * unit;
}

void report_order(const strong_question& q, const squared_errors& errors, const strong_finding& found,
                  recorder& record) {
  curve error{error_quantity};
  for (int l = 0; l < errors.levels; ++l) {
    const auto m = level_mean(errors, l);
    const auto root = [](double x) { return std::sqrt(std::max(0.0, x)); };
    error.add(q.dt[static_cast<std::size_t>(l)], root(m.mean), root(m.mean - 1.96 * m.error),
              root(m.mean + 1.96 * m.error));
  }
  const auto& fit = found.fit;
  std::vector<report::series_id> evidence{record.series(error, fit)};
  const double claimed = q.claimed();
  auto order = judge_order(claimed, fit, false);
  if (fit && fit->high > claimed + order_margin && fit->low >= claimed - order_margin)
    judge_hidden_order(found.leading, claimed, *fit, order);
  if (found.areas.known) {
    judge_areas(found.areas, order);
    evidence.push_back(record.id(area_quantity));
  }
  record.verdict("strong order", order, evidence);
}

void report_limit(const strong_question& q, const std::vector<direction>& directions, const strong_finding& found,
                  recorder& record) {
  std::vector<report::series_id> evidence;
  // A scheme with areas is compared with the truth itself, one without with its twin, whose distance is no row.
  if (q.scheme.needs_areas) evidence.push_back(record.id(error_quantity, report::step_size));
  for (std::size_t i = 0; i < found.limit.strengths.size(); ++i)
    if (const auto& m = found.limit.strengths[i]; m.known)
      evidence.push_back(record_strength(strength_of(directions[i].name), m, record));
  if (found.areas.known) record_strength(area_quantity, found.areas, record);
  record.verdict("limit is the Stratonovich solution",
                 judge_limit(found.limit, directions, length(q.c.subject.scene.momentum)), evidence);
}

}  // namespace polhode
