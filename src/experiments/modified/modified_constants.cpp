// SPDX-License-Identifier: Apache-2.0
#include "experiments/modified/modified_constants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/undecided.hpp"
#include "sphere/uniqueness.hpp"
#include "statistics/orders/power_series.hpp"

namespace polhode {
namespace {

constexpr int degree = 12, finer = 16;
constexpr const char *weak_constant = "leading constant of the weak error",
                     *bias_constant = "leading constant of the stationary bias";
constexpr std::array<double, 4> expansion_steps{1.0 / 16, 1.0 / 32, 1.0 / 64, 1.0 / 128};  // of the fastest time scale

/// The interval of one rule, and the least that contains those of both.
series_coefficient of_both_rules(const interval_estimate& sharp, const std::optional<expansion_term>& other) {
  series_coefficient out{sharp, sharp};
  if (!other) return out;
  out.sure.low = std::min(sharp.low, other->value - other->certainty());
  out.sure.high = std::max(sharp.high, other->value + other->certainty());
  return out;
}

std::vector<report::series_id> report_constants(const std::string& kind, const std::vector<leading_constant>& constants,
                                                recorder& record) {
  std::vector<report::series_id> written;
  for (const auto& one : constants) {
    const auto add = [&](const char* how, const interval_estimate& e) {
      written.push_back(record.value({fmt::format("{}, {}", kind, how), one.observable, "", "transfer"}, e));
    };
    add("measured", one.measured.sharp);
    add("predicted", one.predicted);
  }
  return written;
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
    std::vector<series_coefficient> series;
    for (const auto& sharp : series_by_all_levels(t.dt, value, uncertainty, static_cast<std::size_t>(order) + 1))
      series.push_back(
          of_both_rules(sharp, series_term_by_best_degree(t.dt, value, uncertainty, static_cast<int>(series.size()))));
    const auto k = static_cast<std::size_t>(i);
    leading_constant c{averages.names[k], averages.size[i], series.back(), predicted[k], {}};
    series.pop_back();
    c.below = std::move(series);
    out.push_back(std::move(c));
  }
  return out;
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
             one_law = noisy && no_unique_law(*c.subject.sphere()).empty();
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
    recorder record("modified", tables[k].scheme, out);
    const std::span all(predicted[k]);
    const auto report = [&](const char* what, const exact_averages& kind, Eigen::Index before) {
      if (kind.count() == 0) return;
      const auto found = leading_constants(kind, tables[k], modified_columns::count + before,
                                           all.subspan(static_cast<std::size_t>(before)), orders[k]);
      const auto rows = report_constants(what, found, record);
      record.verdict(what, judge_constants(found, orders[k], rate), rows);
    };
    report(weak_constant, averages.at_horizon, 0);
    report(bias_constant, averages.stationary, averages.at_horizon.count());
  }
}

}  // namespace polhode
