// SPDX-License-Identifier: Apache-2.0
// Where lambda_1 > 0 the bodies under one noise gather on a fractal: its dimensions at sizes of boxes that can be
// filled. In the limit of small boxes the information dimension is that of Kaplan and Yorke, 1 + lambda_1 / |lambda_2|
// (Ledrappier and Young, Probab. Theory Relat. Fields 80 (1988) 217, for random maps). Far from that limit rates along
// a path fluctuate more than they are apart, and pieces of the cloud are folded small: nothing is claimed.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "ensemble/observing/sphere_bins.hpp"
#include "experiments/attractor/attractor.hpp"
#include "experiments/common/progress_counter.hpp"
#include "experiments/common/sequential.hpp"
#include "statistics/box_dimension.hpp"

namespace polhode {
namespace {

constexpr int coarsest = 16;                  // boxes along a hemisphere: larger ones see the sphere and its rim
constexpr double longer = 3;                  // than the mean time to fall below a box: rates fluctuate along a path
constexpr double most_dimension_steps = 3e8;  // at quick effort
constexpr std::array names{"box-counting", "information", "correlation"};

struct dimension_plan {
  double dt;
  std::int64_t steps, bodies;
  int paths;
};

/// The side of a box of that many along a hemisphere, by its area on the unit sphere.
double side_of(int boxes) { return std::sqrt(8.0) / boxes; }

using cloud = std::vector<box_level>;

/// Of the Wong-Zakai equation: of nobody's scheme.
std::vector<cloud> clouds_of(const context& c, const dimension_plan& plan, const path_listener& hear) {
  auto p = common_noise_plan(c);
  p.steps = plan.steps;
  p.bodies = plan.bodies;
  p.snapshots = {plan.steps};
  const auto stepper = c.subject.model->reference(plan.dt);
  progress_counter done(plan.paths, c.progress);
  std::vector<cloud> clouds;
  for (int path = 0; path < plan.paths; ++path, done.add()) {
    p.path = static_cast<std::uint64_t>(path);
    p.hear = [&](const increment_view& v) { hear(path, v); };
    const auto run = simulate_ensemble(*c.subject.model, *stepper, p);
    clouds.push_back(count_boxes(run.snapshots[0].picture, 2, hemisphere_bins::side, coarsest));
  }
  return clouds;
}

/// What is seen of one kind of dimension.
struct seen_dimension {
  box_kind kind;
  int finest;
  std::vector<bool> usable;
  std::optional<dimension_estimate> found;
};

/// Why a size of boxes has no part in the line.
std::string why_not(int side, int finest) {
  if (side > finest) return "finer than fixed in advance";
  return fmt::format("an occupied box holds fewer than {:g} bodies", least_fill);
}

/// The numbers of boxes and the dimension.
void report_boxes(const seen_dimension& seen, std::span<const cloud> clouds, recorder& record) {
  const auto k = static_cast<std::size_t>(seen.kind);
  curve boxes{{fmt::format("boxes, {}", names[k]), "snapshot", "", "sampled"}, "side of a box", "1"};
  for (std::size_t i = 0; i < seen.usable.size(); ++i) {
    double log_sum = 0;
    for (const auto& one : clouds) log_sum += std::log(one[i].boxes[k]);
    boxes.add(side_of(clouds.front()[i].side), std::exp(log_sum / static_cast<double>(clouds.size())));
    boxes.points.back().used = seen.usable[i];
    if (!seen.usable[i]) boxes.points.back().status = why_not(clouds.front()[i].side, seen.finest);
  }
  const auto counted = record.series(boxes);
  if (!seen.found) return;
  const auto& d = seen.found->value;
  const double at_one = seen.found->boxes_at_one * std::pow(side_of(1), d.value);
  record.fit(counted, -d.value, -d.high, -d.low, at_one,
             fmt::format("{} sizes of boxes fixed in advance, in which an occupied one holds {:g} bodies or more",
                         std::ranges::count(seen.usable, true), least_fill));
  record.value({fmt::format("{} dimension", names[k]), "", "", "sampled"}, d);
}

}  // namespace

void report_dimensions(const context& c, const attractor_frame& f, noise_log& log, report::results& out) {
  const double time = longer * std::log(1 / side_of(hemisphere_bins::side)) / -f.lambda2();
  const dimension_plan plan{f.dt, f.steps_in(time, f.dt), by_effort(c.effort, 20'480, 40'960, 40'960),
                            by_effort(c.effort, 5, 32, 64)};
  const double path_steps = static_cast<double>(plan.steps * plan.bodies) * plan.paths;
  if (path_steps > affordable(c.effort, most_dimension_steps)) {
    out.skipped.push_back({"attractor", "",
                           fmt::format("dimensions: contracting below a box takes {:.1e} path-steps, and {:.1e} are "
                                       "affordable at this effort",
                                       path_steps, affordable(c.effort, most_dimension_steps))});
    return;
  }
  const double exact = f.exponents.dimension;
  recorder record("attractor", "", out);
  record.value({"Kaplan-Yorke dimension", "", "", "exact"}, exact, exact, exact);
  const auto part = log.open({"dimensions"}, blocks_of(plan.paths));
  const auto clouds =
      clouds_of(c, plan, [&](int path, const increment_view& v) { log.add_path(path, v, plan.dt, part); });
  const int finest = finest_side(static_cast<double>(plan.bodies), exact);
  const auto usable = usable_levels(clouds, finest);
  for (const auto kind : box_kinds)
    report_boxes({kind, finest, usable, fit_dimension(clouds, kind, usable)}, clouds, record);
}

}  // namespace polhode
