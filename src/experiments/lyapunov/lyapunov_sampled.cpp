// SPDX-License-Identifier: Apache-2.0
#include "experiments/lyapunov/lyapunov_sampled.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "experiments/common/judge.hpp"
#include "experiments/common/levels.hpp"
#include "experiments/common/recorder.hpp"
#include "experiments/common/undecided.hpp"
#include "experiments/lyapunov/sampled_growth.hpp"
#include "sphere/spectral_gap.hpp"
#include "statistics/control_variates.hpp"
#include "transfer/transfer.hpp"

namespace polhode {
namespace {

constexpr double compared_fineness = 128;  // steps per fastest time scale where exponents are compared
constexpr double compared_margin = 1e-3;   // of the fastest rate: how far an exponent may lie
constexpr double tight_value = 0.35;       // of the margin: the half-width at which sampling stops
constexpr double known_share = 0.1;        // of the margin: how uncertain an exact value may be
constexpr double relaxations = 8;          // until the start is forgotten, to e^-8
constexpr double observed = 5;             // times as long as that
constexpr double observed_briefly = 1;     // where the exponents are known without sampling
constexpr double no_matter = 1e-3;         // of the margin: rounding
constexpr const char* length_claim = "finds lambda_1";

struct exponent {
  std::string name;
  Eigen::VectorXd growth::*values;
  std::optional<double> exact;  // empty: nothing to compare with
  double uncertainty;
};

/// found: by sampling, or without it.
void report_exponent(const exponent& e, const char* method, double dt, const interval_estimate& found, double margin,
                     recorder& record) {
  const auto row = record.value({e.name, "", "per time", method}, at_dt(dt), found);
  if (!e.exact) return;
  report::verdict v{.expected = e.exact, .reason = "not finite: a step of the scheme fails"};
  if (std::isfinite(found.value)) {
    v.estimate = found.value;
    v.low = found.low;
    v.high = found.high;
    v.kind = judge(*e.exact, found.low, found.high, margin - e.uncertainty);
    v.reason = fmt::format("[{:.6f}, {:.6f}] at dt = {:.3g} against {:.6f} +- {:.2g}", found.low, found.high, dt,
                           *e.exact, margin);
  }
  record.verdict("finds " + e.name, std::move(v), {row});
}

report::verdict judge_controls(const control_means& found, bool with_growth) {
  report::verdict v{.expected = 0.0, .reason = "not finite: a step of the scheme fails"};
  if (!std::isfinite(found.largest)) return v;
  const double limit = audit_threshold(static_cast<std::size_t>(found.count));
  v.estimate = found.largest;
  v.kind = std::fabs(found.largest) <= limit ? report::verdict_kind::holds : report::verdict_kind::refuted;
  v.reason =
      fmt::format("the largest of {} means{} is {:.1f} standard errors from zero, at most {:.1f}", found.count,
                  with_growth ? ", growth less the scheme's own exponents among them," : "", found.largest, limit);
  return v;
}

/// Of each path until it is observed; empty, and the report says why, if that is unknown or too long.
std::optional<double> time_to_forget(const context& c, std::span<const scheme_entry> schemes, double rate,
                                     report::results& out) {
  const auto p = *c.subject.sphere();
  const auto gap = spectral_gap(p, 1e-3 * p.covariance.trace());
  if (!gap.converged()) {
    leave_open(schemes, "lyapunov", length_claim,
               "how long a start is remembered is not known: the spectral gap is " + gap.reason, out);
    return std::nullopt;
  }
  if (!(*gap.value > 0)) {
    out.skipped.push_back(
        {"lyapunov", "", "sampled exponents: the start is never forgotten: no stationary law is unique"});
    return std::nullopt;
  }
  const double time = relaxations / *gap.value;
  const bool affordable =
      affords(c, schemes,
              {"lyapunov", length_claim, "forgetting the start", "steps a path",
               (1 + observed) * time * compared_fineness * rate, [](effort e) { return by_effort(e, 1e5, 2e5, 2e6); }},
              out);
  return affordable ? std::optional(time) : std::nullopt;
}

/// What all schemes are asked at one step.
struct comparison {
  std::array<exponent, 2> exponents;
  double margin;
};

void report_scheme(const sampled_growth& sampled, std::size_t k, double dt, const comparison& asked,
                   const std::optional<discretisation_growth>& own, recorder& record) {
  const int paths = sampled.size(k).used;
  std::vector<report::series_id> simulated;  // against the exponents of the discretisation
  Eigen::Index i = 0;
  for (const auto& e : asked.exponents) {
    const auto mean = sampled.mean(k, e.values, paths);
    const auto row = [&](const char* how, const interval_estimate& found) {
      return record.value({e.name + how, "", "per time", "sampled"}, at_dt(dt), found);
    };
    if (own) {
      const double value = own->value[i], uncertainty = own->uncertainty[i++];
      report_exponent(e, "transfer", dt, {value, value - uncertainty, value + uncertainty}, asked.margin, record);
      simulated.push_back(row(", simulated", mean));
    } else {
      report_exponent(e, "sampled", dt, mean, asked.margin, record);
      row(", no controls", sampled.raw_mean(k, e.values, paths));
    }
  }
  const auto controls = own ? sampled.controls(k, paths, *own, no_matter * asked.margin) : sampled.controls(k, paths);
  record.verdict("controls have mean zero", judge_controls(controls, own.has_value()), simulated);
  record.remark(sampled.size(k).text());
}

}  // namespace

double compared_step(const subject& s) { return 1 / (compared_fineness * fastest_rate(s)); }

void report_sampled_exponents(const context& c, const std::vector<scheme_entry>& schemes,
                              const lyapunov_exponents& exact, report::results& out,
                              const std::function<known_growths()>& ask) {
  const double margin = compared_margin * fastest_rate(c.subject);
  const auto forgotten = time_to_forget(c, schemes, fastest_rate(c.subject), out);
  if (!forgotten) return;
  const bool known = exact.lambda1 && std::max(exact.uncertainty, exact.sum_uncertainty) <= known_share * margin;
  std::vector<recorder> records;
  for (const auto& scheme : schemes) {
    records.emplace_back("lyapunov", scheme.info.name, out);
    if (!known) records.back().verdict(length_claim, {.reason = "lambda_1 itself is " + exact.reason});
  }
  const auto if_known = [&](double x) { return known ? std::optional(x) : std::nullopt; };
  const comparison asked{{exponent{"lambda_1", &growth::length, if_known(exact.lambda1.value_or(0)), exact.uncertainty},
                          exponent{"lambda_1 + lambda_2", &growth::area, if_known(exact.sum), exact.sum_uncertainty}},
                         margin};
  const auto own = ask ? ask() : known_growths(schemes.size());
  const auto own_of = [&](std::size_t k) {
    const bool enough = own[k] && own[k]->uncertainty.maxCoeff() <= known_share * margin;
    return enough ? own[k] : std::nullopt;
  };
  for (const bool briefly : {true, false}) {
    std::vector<std::size_t> some;
    std::vector<scheme_entry> entries;
    for (std::size_t k = 0; k < schemes.size(); ++k) {
      if (own_of(k).has_value() != briefly) continue;
      some.push_back(k);
      entries.push_back(schemes[k]);
    }
    if (some.empty()) continue;
    const auto run =
        run_length_of(compared_step(c.subject), *forgotten, (briefly ? observed_briefly : observed) * *forgotten);
    sampled_growth sampled(c, entries, run);
    sampled.sample({256, briefly ? 256 : by_effort(c.effort, 1024, 2048, 4096)}, tight_value * margin);
    for (std::size_t i = 0; i < some.size(); ++i)
      report_scheme(sampled, i, run.dt, asked, own_of(some[i]), records[some[i]]);
    if (!briefly || some.size() == schemes.size()) sampled.report_noise(out);  // of the longest run
  }
}

}  // namespace polhode
