#include "experiments/modified_constants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ensemble/paths.hpp"
#include "experiments/undecided.hpp"
#include "statistics/power_series.hpp"

namespace polhode {
namespace {

constexpr double narrow = 0.01;   // of the largest constant
constexpr double natural = 1e-2;  // of rate^order: a constant below that is small
constexpr int degree = 12, finer = 16;
constexpr const char *weak_constant = "leading constant of the weak error",
                     *bias_constant = "leading constant of the stationary bias";
constexpr std::array<double, 4> expansion_steps{1.0 / 16, 1.0 / 32, 1.0 / 64, 1.0 / 128};  // of the fastest time scale

double half_of(const interval_estimate& e) { return (e.high - e.low) / 2; }

/// The difference of two intervals, which contains zero where they meet.
interval_estimate difference(const leading_constant& c) {
  const double d = c.measured.value - c.predicted.value, half = half_of(c.measured) + half_of(c.predicted);
  return {d, d - half, d + half};
}

bool excludes_zero(const interval_estimate& e) { return e.low > 0 || e.high < 0; }

std::string shown(const interval_estimate& e) { return fmt::format("{:.5g} [{:.5g}, {:.5g}]", e.value, e.low, e.high); }

/// How far from zero an interval lies, in half-widths.
double clear(const interval_estimate& e) { return std::fabs(e.value) / std::max(half_of(e), 1e-300); }

void report_constants(const claim& c, const std::string& kind, const std::vector<leading_constant>& constants,
                      report::results& out) {
  for (const auto& one : constants) {
    const auto add = [&](const char* how, const interval_estimate& e) {
      out.measurements.push_back(
          measured({c.experiment, c.scheme, fmt::format("{}, {}", kind, how), one.observable, "", "transfer"}, {},
                   e.value, e.low, e.high));
    };
    add("measured", one.measured);
    add("predicted", one.predicted);
  }
}

}  // namespace

std::vector<leading_constant> leading_constants(const exact_averages& averages, const error_table& t,
                                                Eigen::Index first, std::span<const interval_estimate> predicted,
                                                int order) {
  std::vector<leading_constant> out;
  if (t.dt.size() < static_cast<std::size_t>(order) + 3) return out;
  for (Eigen::Index i = 0; i < averages.count(); ++i) {
    std::vector<double> value, uncertainty;
    for (std::size_t level = 0; level < t.dt.size(); ++level) {
      value.push_back(t.error[level][first + i]);
      uncertainty.push_back(t.uncertainty[level][first + i]);
    }
    auto series = series_by_all_levels(t.dt, value, uncertainty, static_cast<std::size_t>(order) + 1);
    const auto k = static_cast<std::size_t>(i);
    leading_constant c{averages.names[k], averages.size[i], series.back(), predicted[k], {}};
    series.pop_back();
    c.below = std::move(series);
    out.push_back(std::move(c));
  }
  return out;
}

report::verdict judge_constants(const claim& c, const std::vector<leading_constant>& constants, int order,
                                double rate) {
  report::verdict v{c.experiment, c.scheme, c.text, {}, {}, {}, {}, report::verdict_kind::inconclusive, ""};
  if (constants.empty()) {
    v.reason = fmt::format("too few step sizes for a coefficient of dt^{}", order);
    return v;
  }
  for (const auto& one : constants)
    for (std::size_t power = 0; power < one.below.size(); ++power)
      if (excludes_zero(one.below[power])) {
        v.kind = report::verdict_kind::refuted;
        v.expected = 0;
        v.estimate = one.below[power].value;
        v.low = one.below[power].low;
        v.high = one.below[power].high;
        v.reason =
            fmt::format("error of {} at order dt^{}: {}, not zero", one.observable, power, shown(one.below[power]));
        return v;
      }
  const auto largest = std::ranges::max(
      constants, {}, [](const leading_constant& one) { return std::fabs(one.predicted.value) / one.size; });
  const double allowed =
      narrow * std::max(std::fabs(largest.predicted.value) / largest.size, natural * std::pow(rate, order));
  const auto by_clear = [](const leading_constant& one) { return clear(difference(one)); };
  const auto by_width = [](const leading_constant& one) { return half_of(difference(one)) / one.size; };
  const auto worst = std::ranges::max(constants, {}, by_clear);
  const bool refuted = by_clear(worst) > 1;
  const auto widest = std::ranges::max(constants, {}, by_width);
  const auto& decisive = refuted ? worst : by_width(widest) > allowed ? widest : largest;
  if (refuted)
    v.kind = report::verdict_kind::refuted;
  else if (by_width(widest) <= allowed)
    v.kind = report::verdict_kind::holds;
  v.expected = decisive.predicted.value;
  v.estimate = decisive.measured.value;
  v.low = decisive.measured.low;
  v.high = decisive.measured.high;
  v.reason = fmt::format("{}: {} times dt^{} measured, {} predicted by one step; {} observables", decisive.observable,
                         shown(decisive.measured), order, shown(decisive.predicted), constants.size());
  return v;
}

void keep_affordable(const context& c, const std::vector<scheme_entry>& schemes, law_averages& averages,
                     report::results& out) {
  const auto degree_afforded = [](effort e) { return by_effort(e, 24.0, 48.0, 96.0); };
  const auto keep = [&](exact_averages& some, const std::string& reason, bool applies, const char* claim) {
    if (some.count() == 0 && !applies)
      out.skipped.push_back({"modified", "", fmt::format("{}: {}", claim, reason)});
    else if (some.count() == 0)
      leave_open(schemes, "modified", claim, reason, out);
    return some.count() > 0 && affords(c, schemes,
                                       {"modified", claim, "knowing the averages", "degrees of harmonics",
                                        static_cast<double>(some.degree), degree_afforded},
                                       out);
  };
  const bool noisy = c.subject.model->noise() != noise_class::none,
             one_law = noisy && no_unique_law(*sphere_problem_of(c.subject)).empty();
  if (!keep(averages.at_horizon, averages.no_horizon, noisy, weak_constant)) averages.at_horizon = {};
  const bool bias = keep(averages.stationary, averages.no_law, one_law, bias_constant),
             variance = keep(averages.stationary, averages.no_law, one_law, variance_claim);
  if (!bias || !variance) averages.stationary = {};
}

void report_leading_constants(const context& c, const std::vector<scheme_entry>& schemes, const law_averages& averages,
                              const std::vector<error_table>& tables, const std::vector<int>& orders,
                              report::results& out) {
  if (averages.count() == 0) return;
  const double rate = fastest_rate(c.subject);
  std::vector<double> dt;
  for (const double share : expansion_steps) dt.push_back(share / rate);
  const expansion_frame coarse(c.subject, averages, degree, dt), fine(c.subject, averages, finer, dt);
  std::vector<std::vector<interval_estimate>> predicted(schemes.size());
  parallel_for(c.threads, static_cast<int>(schemes.size()), [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    predicted[k] = predicted_constants(c.subject, schemes[k], averages, coarse, fine, orders[k]);
  });
  for (std::size_t k = 0; k < schemes.size(); ++k) {
    const std::span all(predicted[k]);
    const auto report = [&](const char* what, const exact_averages& kind, Eigen::Index before) {
      if (kind.count() == 0) return;
      const claim about{"modified", tables[k].scheme, what};
      const auto found = leading_constants(kind, tables[k], modified_columns::count + before,
                                           all.subspan(static_cast<std::size_t>(before)), orders[k]);
      report_constants(about, what, found, out);
      out.verdicts.push_back(judge_constants(about, found, orders[k], rate));
    };
    report(weak_constant, averages.at_horizon, 0);
    report(bias_constant, averages.stationary, averages.at_horizon.count());
  }
}

}  // namespace polhode
