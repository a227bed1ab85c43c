// SPDX-License-Identifier: Apache-2.0
#include "experiments/lyapunov/orbit_exponents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/judge.hpp"
#include "experiments/common/levels.hpp"
#include "experiments/common/progress_counter.hpp"
#include "experiments/common/recorder.hpp"
#include "experiments/lyapunov/orbit_runs.hpp"
#include "experiments/lyapunov/orbit_verdicts.hpp"

namespace polhode {
namespace {

constexpr double tight_share = 0.4;    // of the margin: the half-width at which sampling stops
constexpr double volume_share = 1e-3;  // of the fastest rate: how far the sum may lie from the mean divergence
constexpr const char* spectrum_claim = "finds the exponents";
constexpr const char* equation_name = "equation";  // under which it stands among the schemes
constexpr const char* own_sign_claim = "lambda_1 has a sign";
constexpr const char* sign_claim = "finds the sign of lambda_1";
constexpr const char* volume_claim = "sum of exponents is the mean divergence";
constexpr const char* pairs_claim = "exponents come in pairs";

std::string named(Eigen::Index k) { return fmt::format("lambda_{}", k + 1); }

double volume_margin(const subject& s) { return volume_share * fastest_rate(s); }

/// [path][k]: lambda_k + lambda_{d+1-k}, which vanish for a flow that keeps the symplectic form.
Eigen::MatrixXd pair_sums(const Eigen::MatrixXd& rates) {
  return (rates + rates.rowwise().reverse()).leftCols(rates.cols() / 2);
}

void report_equation(const context& c, const orbit_frame& f, const observed_rates& e, report::results& out) {
  recorder record("lyapunov", "", out);
  std::vector<report::series_id> rows;
  for (Eigen::Index k = 0; k < e.rates.cols(); ++k)
    rows.push_back(record.value({named(k), "", "per time", "sampled"}, at_dt(f.dt), mean_of(e.rates.col(k))));
  record.value({"sum of exponents", "", "per time", "sampled"}, mean_of(e.volume));
  record.value({"mean divergence", "", "per time", "sampled"}, mean_of(e.divergence));
  record.value({"kaplan_yorke_dimension", "", "1", "sampled"}, dimension_of(e.rates, c.seed));
  auto sign = judge_sign(mean_of(e.rates.col(0)));
  if (!e.fault.empty()) sign = {.reason = "the start is not forgotten: " + e.fault};
  recorder("lyapunov", equation_name, out).verdict(own_sign_claim, std::move(sign), {rows.front()});
}

struct scheme_report {
  const context& c;
  const orbit_frame& frame;
  const observed_rates& equation;
  const scheme_paths& paths;

  void write(std::size_t k, recorder& record) const {
    const auto differences = paths.differences(k);
    std::vector<report::series_id> rows;
    for (Eigen::Index i = 0; i < differences.cols(); ++i)
      rows.push_back(record.value({named(i), "", "per time", "sampled"}, at_dt(frame.dt),
                                  corrected(mean_of(equation.rates.col(i)), mean_of(differences.col(i)))));
    if (!equation.fault.empty()) {
      record.verdict(spectrum_claim, {.reason = "the start is not forgotten: " + equation.fault}, rows);
      return;
    }
    record.verdict(spectrum_claim, judge_all(differences, frame.margin, named), rows);
    const auto first = mean_of(equation.rates.col(0));
    if (judge_sign(first).kind == report::verdict_kind::holds)
      record.verdict(sign_claim, judge_sign(first, corrected(first, mean_of(differences.col(0)))), {rows.front()});
    if (dissipation_of(c.subject.scene) == 0)
      record.verdict(pairs_claim,
                     judge_all(pair_sums(paths.rates(k)), frame.margin,
                               [&](Eigen::Index i) { return named(i) + " + " + named(differences.cols() - 1 - i); }),
                     rows);
    record.remark(paths.text(k));
  }
};

void report_volume(const context& c, const orbit_frame& f, const scheme_entry& scheme, const Eigen::VectorXd& defects,
                   report::results& out) {
  recorder record("lyapunov", scheme.info.name, out);
  const auto found = mean_of(defects);
  const auto row = record.value({"sum less mean divergence", "", "per time", "sampled"}, at_dt(f.dt), found);
  const double margin = volume_margin(c.subject);
  report::verdict v{.expected = 0.0, .reason = "not finite: a step of the scheme fails"};
  if (std::isfinite(found.value)) {
    v.estimate = found.value;
    v.low = found.low;
    v.high = found.high;
    v.kind = judge(0, found.low, found.high, margin);
    v.reason = fmt::format("off by {:.6f} [{:.6f}, {:.6f}] at dt and dt/2 extrapolated to 0, at most {:.2g} is allowed",
                           found.value, found.low, found.high, margin);
  }
  record.verdict(volume_claim, std::move(v), {row});
}

std::vector<scheme_entry> schemes_on_the_orbit(const subject& s, report::results& out) {
  std::vector<scheme_entry> kept;
  for (const auto& scheme : s.schemes)
    if (scheme.info.casimir.exact)
      kept.push_back(scheme);
    else
      out.skipped.push_back({"lyapunov", std::string(scheme.info.name),
                             "leaves its orbit (experiment casimir), on which the exponents are defined"});
  return kept;
}

}  // namespace

std::optional<std::string> no_orbit_exponents(const subject& s) {
  if (s.model->noise() == noise_class::none) return "no noise: there is no random flow";
  if (dissipation_of(s.scene) == 0 && !keeps_length(*s.model))
    return "no dissipation on orbits that are not compact: noise spreads bodies for ever, and no law is stationary";
  return std::nullopt;
}

void report_orbit_exponents(const context& c, report::results& out) {
  const orbit_frame frame(c);
  const auto schemes = schemes_on_the_orbit(c.subject, out);
  if (!frame.affordable(c, schemes, "lyapunov", spectrum_claim, out)) return;
  noise_log log(*c.subject.model, blocks_of(frame.paths));
  observed_rates equation;
  const auto observe = [&] { equation = observe_equation(part_of(c, 0, 0.3), frame, frame.vectors(), log); };
  std::vector<Eigen::VectorXd> defects(schemes.size());
  // One block of the equation's paths keeps one thread busy: it goes beside the schemes.
  const int before = frame.paths > block_lanes;
  if (before) observe();
  parallel_for(c.threads, static_cast<int>(schemes.size()) + 1 - before, [&](int k) {
    if (k + before == 0) return observe();
    const auto i = static_cast<std::size_t>(k + before - 1);
    defects[i] = volume_defects(c, frame, schemes[i], tight_share * volume_margin(c.subject));
  });
  report_equation(c, frame, equation, out);
  if (schemes.empty()) return;
  const auto last = part_of(c, 0.4, 1);
  scheme_paths paths(last, frame, schemes, equation, frame.vectors(),
                     [&](const scheme_entry& e) { return derivative_flow(e.tangent(frame.dt)); });
  paths.sample(tight_share * frame.margin);
  for (std::size_t k = 0; k < schemes.size(); ++k) {
    report_volume(c, frame, schemes[k], defects[k], out);
    recorder record("lyapunov", schemes[k].info.name, out);
    scheme_report{c, frame, equation, paths}.write(k, record);
  }
  log.report("lyapunov", out);
}

}  // namespace polhode
