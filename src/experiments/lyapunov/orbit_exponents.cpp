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
#include "experiments/common/undecided.hpp"
#include "experiments/lyapunov/orbit_runs.hpp"
#include "statistics/distributions.hpp"
#include "statistics/resample.hpp"
#include "statistics/resampled_means.hpp"

namespace polhode {
namespace {

constexpr double tight_share = 0.4;    // of the margin: the half-width at which sampling stops
constexpr double volume_share = 2e-3;  // of the fastest rate: how far the sum may lie from the mean divergence
constexpr const char* spectrum_claim = "finds the exponents";
constexpr const char* sign_claim = "finds the sign of lambda_1";
constexpr const char* volume_claim = "sum of exponents is the mean divergence";
constexpr const char* pairs_claim = "exponents come in pairs";

interval_estimate mean_of(const Eigen::VectorXd& values) {
  return mean_interval({values.data(), static_cast<std::size_t>(values.size())});
}

std::string named(Eigen::Index k) { return fmt::format("lambda_{}", k + 1); }

/// Means that should vanish, judged together: the intervals cover all at once with 95 % (Bonferroni).
report::verdict judge_all(const Eigen::MatrixXd& values, double margin,
                          const std::function<std::string(Eigen::Index)>& name) {
  const auto count = static_cast<double>(values.cols());
  const double wider = normal_deviate(0.025 / count) / normal_deviate(0.025);
  report::verdict v{.expected = 0.0, .kind = report::verdict_kind::holds};
  double furthest = -1;
  for (Eigen::Index k = 0; k < values.cols(); ++k) {
    const auto found = mean_of(values.col(k));
    if (!std::isfinite(found.value)) return {.expected = 0.0, .reason = "not finite: a step of the scheme fails"};
    const double half = wider * half_width(found), low = found.value - half, high = found.value + half;
    const auto kind = judge(0, low, high, margin);
    if (kind == report::verdict_kind::refuted || v.kind == report::verdict_kind::holds) v.kind = kind;
    if (std::max(-low, high) <= furthest) continue;
    furthest = std::max(-low, high);
    v.estimate = found.value;
    v.low = low;
    v.high = high;
    v.reason = fmt::format("furthest is {}: off by {:.5f} [{:.5f}, {:.5f}], at most {:.2g} is allowed", name(k),
                           found.value, low, high, margin);
  }
  return v;
}

/// [path][k]: lambda_k + lambda_{d+1-k}, which vanish for a flow that keeps the symplectic form.
Eigen::MatrixXd pair_sums(const Eigen::MatrixXd& rates) {
  return (rates + rates.rowwise().reverse()).leftCols(rates.cols() / 2);
}

interval_estimate dimension_of(const Eigen::MatrixXd& rates, std::uint64_t seed) {
  const auto dimension = [](Eigen::RowVectorXd means) {
    std::ranges::sort(means, std::greater());
    return kaplan_yorke({means.data(), static_cast<std::size_t>(means.size())});
  };
  const Eigen::MatrixXd resampled = resampled_means(rates, seed);
  std::vector<double> found;
  for (Eigen::Index i = 0; i < resampled.rows(); ++i) found.push_back(dimension(resampled.row(i)));
  const auto [low, high] = central_interval(found, 0.95);
  return {dimension(rates.colwise().mean()), low, high};
}

void report_equation(const context& c, const orbit_frame& f, const observed_rates& e, report::results& out) {
  recorder record("lyapunov", "", out);
  const auto value = [&](const std::string& name, const std::string& unit, const interval_estimate& found) {
    record.value({name, "", unit, "sampled"}, at_dt(f.dt), found);
  };
  for (Eigen::Index k = 0; k < e.rates.cols(); ++k) value(named(k), "per time", mean_of(e.rates.col(k)));
  value("sum of exponents", "per time", mean_of(e.volume));
  value("mean divergence", "per time", mean_of(e.divergence));
  value("kaplan_yorke_dimension", "1", dimension_of(e.rates, c.seed));
}

report::verdict judge_sign(const interval_estimate& of_equation, const interval_estimate& of_scheme) {
  const auto sign = [](const interval_estimate& x) { return x.low > 0 ? 1 : x.high < 0 ? -1 : 0; };
  report::verdict v{.estimate = of_scheme.value, .low = of_scheme.low, .high = of_scheme.high};
  const int expected = sign(of_equation), found = sign(of_scheme);
  const auto text = fmt::format("lambda_1 = {:.4f} [{:.4f}, {:.4f}], of the equation [{:.4f}, {:.4f}]", of_scheme.value,
                                of_scheme.low, of_scheme.high, of_equation.low, of_equation.high);
  if (expected == 0 || found == 0) {
    v.reason = "neither spreading nor collecting is certain: " + text;
    return v;
  }
  v.kind = expected == found ? report::verdict_kind::holds : report::verdict_kind::refuted;
  v.reason = (found > 0 ? "one noise spreads neighbours, chaos: " : "one noise collects neighbours: ") + text;
  return v;
}

/// The equation's mean over all its paths, and the difference on those that both have.
interval_estimate corrected(const interval_estimate& of_equation, const interval_estimate& difference) {
  const double value = of_equation.value + difference.value,
               half = std::hypot(half_width(of_equation), half_width(difference));
  return {value, value - half, value + half};
}

struct scheme_report {
  const context& c;
  const orbit_frame& frame;
  const observed_rates& equation;
  const scheme_paths& paths;

  void write(std::size_t k, recorder& record) const {
    const int used = paths.size(k).used;
    const auto differences = paths.differences(k, used);
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
    record.verdict(sign_claim, judge_sign(first, corrected(first, mean_of(differences.col(0)))), {rows.front()});
    if (dissipation_of(c.subject.scene) == 0)
      record.verdict(pairs_claim,
                     judge_all(pair_sums(paths.rates(k, used)), frame.margin,
                               [&](Eigen::Index i) { return named(i) + " + " + named(differences.cols() - 1 - i); }),
                     rows);
    record.remark(paths.size(k).text());
  }
};

void report_volume(const context& c, const orbit_frame& f, const scheme_entry& scheme, const Eigen::VectorXd& defects,
                   report::results& out) {
  recorder record("lyapunov", scheme.info.name, out);
  const auto found = mean_of(defects);
  const auto row = record.value({"sum less mean divergence", "", "per time", "sampled"}, at_dt(f.dt), found);
  const double margin = volume_share * fastest_rate(c.subject);
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

double kaplan_yorke(std::span<const double> exponents) {
  double sum = 0;
  std::size_t j = 0;
  for (; j < exponents.size() && sum + exponents[j] >= 0; ++j) sum += exponents[j];
  if (exponents.empty() || exponents[0] <= 0) return 0;
  return static_cast<double>(j) + (j < exponents.size() ? sum / std::fabs(exponents[j]) : 0);
}

std::optional<std::string> no_orbit_exponents(const subject& s) {
  if (s.model->noise() == noise_class::none) return "no noise: there is no random flow";
  if (dissipation_of(s.scene) == 0 && !keeps_length(*s.model))
    return "no dissipation on orbits that are not compact: noise spreads bodies for ever, and no law is stationary";
  return std::nullopt;
}

void report_orbit_exponents(const context& c, report::results& out) {
  const orbit_frame frame(c);
  noise_log log(*c.subject.model, blocks_of(frame.paths));
  const auto equation = observe_equation(part_of(c, 0, 0.3), frame, log);
  report_equation(c, frame, equation, out);
  const auto schemes = schemes_on_the_orbit(c.subject, out);
  if (schemes.empty()) return;
  std::vector<Eigen::VectorXd> defects(schemes.size());
  parallel_for(c.threads, static_cast<int>(schemes.size()), [&](int k) {
    const auto i = static_cast<std::size_t>(k);
    defects[i] = volume_defects(c, frame, schemes[i]);
  });
  const auto last = part_of(c, 0.4, 1);
  scheme_paths paths(last, frame, schemes, equation);
  paths.sample(tight_share * frame.margin);
  for (std::size_t k = 0; k < schemes.size(); ++k) {
    report_volume(c, frame, schemes[k], defects[k], out);
    recorder record("lyapunov", schemes[k].info.name, out);
    scheme_report{c, frame, equation, paths}.write(k, record);
  }
  log.report("lyapunov", out);
}

}  // namespace polhode
