// Where lambda_1 > 0 the bodies under one noise gather on a fractal: is its information dimension that of Kaplan and
// Yorke, 1 + lambda_1 / |lambda_2|?  (Ledrappier and Young, Probab. Theory Relat. Fields 80 (1988) 217, for random
// maps.)
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ensemble/observing/sphere_bins.hpp"
#include "experiments/attractor/attractor.hpp"
#include "experiments/common/progress_counter.hpp"
#include "experiments/common/sequential.hpp"
#include "experiments/common/undecided.hpp"
#include "experiments/laws/transfer_report.hpp"
#include "statistics/box_dimension.hpp"

namespace polhode {
namespace {

constexpr int coarsest = 16;  // boxes along a hemisphere: larger ones see the sphere and its rim
constexpr double dimension_margin = 0.15;
constexpr int noise_paths = 64;            // a third of the margin is then left to the interval
constexpr double longer = 2;               // than the mean time to fall below a box: rates fluctuate along a path
constexpr double most_path_steps = 1.1e9;  // of one scheme at quick effort
constexpr const char* dimension_claim = "information dimension";
constexpr std::array names{"box-counting", "information", "correlation"};

struct dimension_plan {
  double dt;
  std::int64_t steps, bodies;
  int paths;
};

/// The side of a box of that many along a hemisphere, by its area on the unit sphere.
double side_of(int boxes) { return std::sqrt(8.0) / boxes; }

using cloud = std::vector<box_level>;

/// Of the noise paths first … last - 1.
void add_clouds(const context& c, const dimension_plan& plan, const scheme_entry& scheme, int first, int last,
                const path_listener& hear, std::vector<cloud>& clouds) {
  auto p = common_noise_plan(c);
  p.steps = plan.steps;
  p.bodies = plan.bodies;
  p.snapshots = {plan.steps};
  p.with_areas = scheme.needs_areas;
  const auto stepper = scheme.make(plan.dt);
  for (int path = first; path < last; ++path) {
    p.path = static_cast<std::uint64_t>(path);
    if (hear) p.hear = [&](const increment_view& v) { hear(path, v); };
    const auto run = simulate_ensemble(*c.subject.model, *stepper, p);
    clouds.push_back(count_boxes(run.snapshots[0].picture, 2, hemisphere_bins::side, coarsest));
  }
}

bool tight(const std::vector<cloud>& clouds) {
  const auto found = fit_dimension(clouds, box_kind::information, usable_levels(clouds));
  return found && half_width(found->value) <= 0.2 * dimension_margin;
}

/// Half of the paths where they make the interval tight.
std::vector<cloud> clouds_of(const context& c, const dimension_plan& plan, const scheme_entry& scheme,
                             const path_listener& hear) {
  std::vector<cloud> clouds;
  add_clouds(c, plan, scheme, 0, plan.paths / 2, hear, clouds);
  if (!tight(clouds)) add_clouds(c, plan, scheme, plan.paths / 2, plan.paths, hear, clouds);
  return clouds;
}

/// What is seen of one kind of dimension.
struct seen_dimension {
  box_kind kind;
  std::vector<bool> usable;
  std::optional<dimension_estimate> found;
};

/// The numbers of boxes and the dimension.
std::vector<report::series_id> report_boxes(const seen_dimension& seen, std::span<const cloud> clouds,
                                            recorder& record) {
  const auto k = static_cast<std::size_t>(seen.kind);
  curve boxes{{fmt::format("boxes, {}", names[k]), "snapshot", "", "sampled"}, "side of a box", "1"};
  for (std::size_t i = 0; i < seen.usable.size(); ++i) {
    double log_sum = 0;
    for (const auto& one : clouds) log_sum += std::log(one[i].boxes[k]);
    boxes.add(side_of(clouds.front()[i].side), std::exp(log_sum / static_cast<double>(clouds.size())));
    boxes.points.back().used = seen.usable[i];
    if (!seen.usable[i])
      boxes.points.back().status = fmt::format("an occupied box holds fewer than {:g} bodies", least_fill);
  }
  const auto counted = record.series(boxes);
  if (!seen.found) return {counted};
  const auto& d = seen.found->value;
  const double at_one = seen.found->boxes_at_one * std::pow(side_of(1), d.value);
  record.fit(counted, -d.value, -d.high, -d.low, at_one,
             fmt::format("{} sizes of boxes in which an occupied one holds {:g} bodies or more",
                         std::ranges::count(seen.usable, true), least_fill));
  return {counted, record.value({fmt::format("{} dimension", names[k]), "", "", "sampled"}, d)};
}

report::verdict judge_dimension(const dimension_plan& plan, double exact, std::size_t paths,
                                const std::optional<dimension_estimate>& found) {
  if (!found) return {.expected = exact, .reason = "fewer than three sizes of boxes are full enough"};
  const auto& d = found->value;
  return {
      .expected = exact,
      .estimate = d.value,
      .low = d.low,
      .high = d.high,
      .kind = judge(exact, d.low, d.high, dimension_margin),
      .reason = fmt::format("{:.3f} [{:.3f}, {:.3f}] against Kaplan-Yorke {:.3f} +- {:g}: {} bodies, dt = {:.4g}, {}",
                            d.value, d.low, d.high, exact, dimension_margin, plan.bodies, plan.dt,
                            sample_size{static_cast<int>(paths), plan.paths}.text())};
}

void report_clouds(const dimension_plan& plan, double exact, std::span<const cloud> clouds, recorder& record) {
  const auto usable = usable_levels(clouds);
  report::verdict information;
  std::vector<report::series_id> evidence;
  for (const auto kind : box_kinds) {
    const auto found = fit_dimension(clouds, kind, usable);
    const auto written = report_boxes({kind, usable, found}, clouds, record);
    if (kind != box_kind::information) continue;
    evidence = written;
    information = judge_dimension(plan, exact, clouds.size(), found);
  }
  record.verdict(dimension_claim, information, evidence);
}

std::vector<scheme_entry> tried(const context& c, const attractor_frame& f, report::results& out) {
  std::vector<scheme_entry> schemes;
  for (const auto& scheme : f.schemes)
    if (c.effort != effort::quick || weak_order_on(scheme.info, c.subject.model->noise()) >= 2)
      schemes.push_back(scheme);
    else
      leave_untried({&scheme, 1}, "attractor", dimension_claim, "at quick effort of schemes of weak order two alone",
                    out);
  return schemes;
}

}  // namespace

void report_dimensions(const context& c, const attractor_frame& f, noise_log& log, report::results& out) {
  const double time = longer * std::log(1 / side_of(hemisphere_bins::side)) / -f.lambda2();
  const dimension_plan plan{f.dt, f.steps_in(time, f.dt), by_effort(c.effort, 20'480, 40'960, 40'960), noise_paths};
  const double path_steps = static_cast<double>(plan.steps * plan.bodies) * plan.paths;
  if (!affords(c, f.schemes,
               {"attractor", dimension_claim, "contracting below a box", "path-steps a scheme", path_steps,
                [](effort e) { return affordable(e, most_path_steps); }},
               out))
    return;
  const double exact = f.exponents.dimension;
  recorder("attractor", "", out).value({"Kaplan-Yorke dimension", "", "", "exact"}, exact, exact, exact);
  const auto schemes = tried(c, f, out);
  progress_counter done(static_cast<int>(schemes.size()), c.progress);
  const auto part = log.open({"dimensions"}, blocks_of(plan.paths));
  const path_listener hear = [&](int path, const increment_view& v) { log.add_path(path, v, plan.dt, part); };
  for (const auto& scheme : schemes) {
    const auto clouds = clouds_of(c, plan, scheme, &scheme == &heard_among(schemes) ? hear : path_listener{});
    recorder record("attractor", scheme.info.name, out);
    report_clouds(plan, exact, clouds, record);
    done.add();
  }
}

}  // namespace polhode
