// SPDX-License-Identifier: Apache-2.0
#include "experiments/strong/path_orders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/common/judge.hpp"
#include "problem/vectors.hpp"
#include "statistics/orders/level_choice.hpp"
#include "statistics/orders/path_slopes.hpp"

namespace polhode {
namespace {

using report::verdict_kind;

constexpr int least_times = 32;

using lane_values = std::array<double, block_lanes>;

/// Squared, of each lane.
lane_values distances(std::span<const double> a, std::span<const double> b) {
  lane_values square{};
  for (std::size_t at = 0; at < a.size(); at += block_lanes)
    for (std::size_t lane = 0; lane < block_lanes; ++lane) {
      const double e = a[at + lane] - b[at + lane];
      square[lane] += e * e;
    }
  return square;
}

/// What is not a number stays.
double larger(double now, double so_far) { return now <= so_far || std::isnan(so_far) ? so_far : now; }

void take_larger(const lane_values& now, lane_values& so_far) {
  for (std::size_t lane = 0; lane < block_lanes; ++lane) so_far[lane] = larger(now[lane], so_far[lane]);
}

/// A slope below the claim refutes it, a steeper one does not: that an order is no higher than claimed is asked of the
/// mean square alone.
report::verdict judge_at_least(const path_order_question& q, const std::optional<order_fit>& fit) {
  auto v = judge_order(q.claimed, fit, true);
  if (v.kind != verdict_kind::inconclusive || !fit || fit->low < q.claimed - order_margin || !q.claimed_seen) return v;
  v.kind = verdict_kind::holds;
  v.reason = fmt::format("order {:.3f} [{:.3f}, {:.3f}] at these dt, above the claimed {:g}, whose term is there",
                         fit->order, fit->low, fit->high, q.claimed);
  return v;
}

struct norm_in_words {
  const char *quantity, *claim;
  error_norm norm;
  std::string how = {};  ///< it was measured: a remark for the reason
};

void report_norm(const path_order_question& q, const norm_in_words& n, const std::optional<order_fit>& fit,
                 recorder& record) {
  curve error{{n.quantity, "state", "|mu|", "sampled"}};
  for (std::size_t l = 0; l < q.dt.size(); ++l) {
    const auto m = level_norm(*n.norm.squares, n.norm.p, static_cast<int>(l));
    error.add(q.dt[l], m.mean, std::max(0.0, m.mean - 1.96 * m.error), m.mean + 1.96 * m.error);
  }
  const auto evidence = record.series(error, fit);
  auto v = judge_at_least(q, fit);
  v.reason += n.how;
  record.verdict(n.claim, v, {evidence});
}

void report_path_slopes(const path_order_question& q, const squared_errors& largest,
                        const std::optional<order_fit>& levels, recorder& record) {
  const auto found =
      levels ? fit_path_slopes(q.dt, largest, *levels, q.claimed - order_margin) : std::optional<path_slopes>{};
  auto v = judge_at_least(q, found ? std::optional(found->median) : std::optional<order_fit>{});
  std::vector<report::series_id> evidence;
  if (found) {
    evidence.push_back(
        record.value({"slope of single paths", "state", "", "sampled"}, found->median.order, found->low, found->high));
    v.reason += fmt::format("; {}; {:.0f} % are at least {:g}", found->median.rule, 100 * found->share_at_least,
                            q.claimed - order_margin);
  }
  record.verdict("strong order of almost every path", v, evidence);
}

}  // namespace

int looks_in_coarsest(const level_grid& grid) {
  const auto& steps = grid.steps;
  const int of_the_fit = steps[steps.size() - std::min<std::size_t>(steps.size(), fitted_levels)];
  return (of_the_fit < least_times ? of_the_fit : steps[steps.size() - 2]) / steps.front();
}

void largest_errors::advance(const kernel& k, const driven_block& truth, std::size_t level, int first_path,
                             std::span<double> states) {
  const auto& steps = truth.increments(level);
  const auto course = truth.course();
  const int looks = std::min(steps.steps, static_cast<int>(course.size())), each = steps.steps / looks;
  const std::size_t apart = course.size() / static_cast<std::size_t>(looks);
  lane_values worst{};
  for (int i = 0; i < looks; ++i) {
    k.advance(states, steps.part(i * each, each));
    take_larger(distances(states, course[static_cast<std::size_t>(i + 1) * apart - 1]), worst);
  }
  for (int lane = 0; lane < block_lanes; ++lane) {
    auto& so_far = squares.at(first_path + lane, static_cast<int>(level));
    so_far = larger(worst[static_cast<std::size_t>(lane)], so_far);
  }
}

void report_path_orders(const path_order_question& q, const squared_errors& at_the_end, const squared_errors& largest,
                        recorder& record) {
  const int fewest = q.grid.steps.front();
  const std::array norms{
      norm_in_words{"error in sup",
                    "strong order in the supremum over time",
                    {&largest, 2},
                    fmt::format(" (largest over the ends of a level's steps, {} to {} times)", fewest,
                                fewest * looks_in_coarsest(q.grid))},
      norm_in_words{"error in L1", "strong order in L^1", {&at_the_end, 1}},
      norm_in_words{"error in L4", "strong order in L^4", {&at_the_end, 4}},
  };
  std::vector<error_norm> asked;
  for (const auto& n : norms) asked.push_back(n.norm);
  const auto fits = fit_orders(q.dt, asked, 1e-13 * length(q.c.subject.scene.momentum), q.c.seed);
  for (std::size_t i = 0; i < norms.size(); ++i) report_norm(q, norms[i], fits[i], record);
  report_path_slopes(q, largest, fits.front(), record);
}

}  // namespace polhode
