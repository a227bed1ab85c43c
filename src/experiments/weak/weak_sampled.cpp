// SPDX-License-Identifier: Apache-2.0
#include "experiments/weak/weak_sampled.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/judge.hpp"
#include "experiments/common/recorder.hpp"
#include "experiments/common/sequential.hpp"
#include "experiments/weak/coupled_levels.hpp"
#include "experiments/weak/exact_means.hpp"
#include "problem/vectors.hpp"

namespace polhode {
namespace {

constexpr double resolved = 5;  // standard errors

/// Of one scheme: errors and fits of the observables and, last, of all of them together.
struct scheme_finding {
  std::vector<squared_errors> errors = {};
  std::vector<std::optional<order_fit>> fits = {};
  path_limit limit = {};
};

std::vector<report::series_id> report_levels(const std::vector<observable>& observables, std::span<const double> dt,
                                             const scheme_finding& found, recorder& record) {
  std::vector<report::series_id> written;
  const auto report_one = [&](const std::string& name, std::size_t f) {
    const auto& d = found.errors[f];
    curve size{{sampled_error, name, "", "sampled"}}, variance{{"variance of the difference", name, "", "sampled"}};
    for (int l = 0; l < d.levels; ++l) {
      const auto m = level_mean(d, l);
      const double mean = std::fabs(m.mean), step = dt[static_cast<std::size_t>(l)];
      size.add(step, mean, std::max(0.0, mean - 1.96 * m.error), mean + 1.96 * m.error);
      variance.add(step, m.error * m.error * d.paths);
    }
    written.push_back(record.series(size, found.fits[f]));
    if (f == observables.size()) record.series(variance);
  };
  report_one(all_together, observables.size());
  for (std::size_t f = 0; f < observables.size(); ++f) report_one(observables[f].name, f);
  return written;
}

/// E[f(X_dt)] against the exact mean; 95 % intervals, as wide as f(X) is uncertain.
void report_against(const reference_value& exact, const std::string& name, std::span<const double> dt,
                    const squared_errors& values, recorder& record) {
  curve error{{"error against the true mean", name, "", "sampled"}};
  for (int l = 0; l < values.levels; ++l) {
    const auto m = level_mean(values, l);
    const double apart = m.mean - *exact.value, around = 1.96 * m.error + exact.uncertainty;
    error.add(dt[static_cast<std::size_t>(l)], apart, apart - around, apart + around);
  }
  record.series(error);
}

/// Of a long state fewer paths: each costs as much more.
sampling_plan plan_for(const context& c) {
  constexpr int usual = 6, first = 1024;
  const int most = by_effort(c.effort, 8192, 16384, 32768);
  return {first, std::max(first, most * usual / std::max(usual, c.subject.model->dimension()))};
}

}  // namespace

void report_sampled_orders(const context& c, const std::vector<scheme_entry>& schemes,
                           const std::vector<observable>& observables,
                           const std::function<double(const scheme_entry&)>& expected, report::results& out) {
  const auto plan = plan_for(c);
  coupled_levels levels(c, schemes, observables, blocks_of(plan.most) * block_lanes);
  const auto dt = levels.grid().dt();
  std::vector<scheme_finding> found(schemes.size());
  const auto sizes = sample_until_tight(
      c, plan, static_cast<int>(schemes.size()),
      [&](int block, std::span<const int> open) { levels.run_block(block, open); },
      [&](int scheme, int so_far) {
        auto& f = found[static_cast<std::size_t>(scheme)];
        f = {levels.errors(scheme, so_far, resolved), {}, levels.limit(scheme, so_far)};
        const auto together = fit_order_of_clear_means(dt, f.errors.back(), resolved, c.seed);
        return tight(f.limit) && together && half_width(*together) <= tight_order;
      });
  parallel_for(c.threads, static_cast<int>(schemes.size()), [&](int k) {
    auto& f = found[static_cast<std::size_t>(k)];
    for (const auto& d : f.errors) f.fits.push_back(fit_order_of_clear_means(dt, d, resolved, c.seed));
  });
  const auto exact = exact_means_of(c.subject, observables, levels.grid().horizon);
  if (!exact.reason.empty()) out.skipped.push_back({"weak", "", "true means of a pair: " + exact.reason});
  // Over a scheme's own paths, and for all schemes over those that each has, so that none depends on what others need.
  const auto truth_over = [&](int paths) {
    return exact.known() ? held_to(exact, observables, levels.truth(paths)) : held_truth{};
  };
  report_truth(truth_over(plan.first), out);
  const double size = length(c.subject.scene.momentum);
  for (std::size_t k = 0; k < schemes.size(); ++k) {
    const auto how = fmt::format("; sampled against paths of the driven equation, at time {:.4g} of {:.4g}, {}",
                                 levels.grid().horizon, c.subject.scene.horizon, sizes[k].text());
    recorder record("weak", schemes[k].info.name, out);
    const auto written = report_levels(observables, dt, found[k], record);
    if (exact.of.front().converged())
      report_against(exact.of.front(), observables.front().name, dt,
                     levels.values(static_cast<int>(k), 0, sizes[k].used), record);
    record.value({"cost", "", "path-steps", "sampled"}, at_dt(dt.back()), levels.steps_of_a_path() * sizes[k].used);
    const auto truth = truth_over(sizes[k].used);
    auto order = judge_sampled_order(expected(schemes[k]), found[k].fits.back());
    order.reason += fmt::format(" (of all {} observables together)", observables.size()) + how;
    hold_to(truth, order);
    record.verdict(weak_order_claim, std::move(order), written);
    auto limit = judge_limit(found[k].limit, levels.directions(), size);
    limit.reason += how;
    hold_to(truth, limit);
    record.verdict("limit of the law is that of the Stratonovich solution", std::move(limit));
  }
  levels.log().report("weak", out);
}

}  // namespace polhode
