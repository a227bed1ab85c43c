// SPDX-License-Identifier: Apache-2.0
// Averaged over noise paths, is the random measure the stationary law?
//
// Every noise path drives a few bodies from a uniform start until one body alone has forgotten it; their random measure
// is known by its harmonics. More bodies of one path say little: where they meet they are one. So it is twelve times
// over, each time once a body has forgotten the last look to a tenth: as good as another path, at a third of its steps.
// Paths of one average are looked at at one time, so that they are independent of each other. The mean over N paths of
// one scheme has the distance E D^2 = b^2 + V / N from the true law, b the distance of the scheme's own stationary law,
// which its transfer operator gives exactly.
#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "ensemble/noise/paths.hpp"
#include "ensemble/noise/shared_increments.hpp"
#include "ensemble/uniform_start.hpp"
#include "experiments/attractor/attractor.hpp"
#include "experiments/attractor/harmonic_moments.hpp"
#include "experiments/attractor/path_averages.hpp"
#include "experiments/common/progress_counter.hpp"
#include "experiments/common/sequential.hpp"
#include "experiments/common/undecided.hpp"
#include "sphere/harmonics/harmonics.hpp"
#include "transfer/basis_sums.hpp"
#include "transfer/transfer_refine.hpp"

namespace polhode {
namespace {

constexpr int moment_degree = 2;
constexpr double start_forgotten = 1e-3;  // a hundredth of the bound
constexpr int looks = 12;                 // at a path, once it is forgotten
constexpr int between_looks = 3;          // the part of that time that lies between them
constexpr double mean_bound = 0.1;        // as in experiment gibbs: a tenth of a standard deviation, of any function
constexpr double tight_mean = 0.4;
constexpr double law_tolerance = 0.02;         // of the scheme's own bias
constexpr double most_average_steps = 1.35e8;  // of one scheme at quick effort
constexpr int least_noise_paths = 320;
constexpr int bodies = sum_lanes;  // of a path
constexpr const char* average_claim = "mean over noise paths";

/// The distance of the scheme's own stationary law from the true one, coefficient by coefficient.
struct own_law {
  Eigen::VectorXd bias;
  double uncertainty = 0;
};

own_law own_law_of(const context& c, const attractor_frame& f, const scheme_entry& scheme) {
  const Eigen::VectorXd exact = harmonic_moments::of_density(*f.law.density, moment_degree);
  const transfer_question q{[](const transfer_operator& op) -> Eigen::VectorXd {
                              return harmonic_moments::of_density(op.stationary_law().transpose(), moment_degree);
                            },
                            {exact, Eigen::VectorXd::Ones(exact.size()), law_tolerance}};
  const auto found = refine(c.subject, scheme, f.dt, 1, q);
  return {found.error, found.uncertainty.norm()};
}

struct scheme_run {
  const scheme_entry* scheme;
  std::unique_ptr<kernel> stepper;
  own_law own;
  Eigen::MatrixXd means;  ///< [coefficient][block, look, noise path], less those of the true law
};

/// When a path is looked at, in steps.
struct time_course {
  std::int64_t first, between;
  std::int64_t until(int look) const { return first + look * between; }
  std::int64_t before(int look) const { return look == 0 ? 0 : until(look - 1); }
  std::int64_t steps() const { return until(looks - 1); }
};

/// Paths that fill a block with their bodies.
struct path_group {
  int first;
  std::span<const shared_increments> noise;
};

void run_group(const context& c, const attractor_frame& f, const time_course& course, const path_group& paths,
               std::span<const int> open, std::vector<scheme_run>& runs) {
  constexpr std::int64_t piece = 32;  // steps: their increments stay in the nearest cache
  const Eigen::VectorXd truth = harmonic_moments::of_density(*f.law.density, moment_degree);
  const auto start = uniform_states(c.seed, static_cast<std::uint64_t>(paths.first) * bodies, f.problem.radius);
  std::vector<std::vector<double>> states(open.size(), start);
  increments_side_by_side noise(paths.noise);
  harmonic_moments means(moment_degree);
  for (int look = 0; look < looks; ++look) {
    for (auto at = course.before(look); at < course.until(look); at += piece) {
      const auto view = noise.view(at, static_cast<int>(std::min(piece, course.until(look) - at)));
      for (std::size_t i = 0; i < open.size(); ++i)
        runs[static_cast<std::size_t>(open[i])].stepper->advance(states[i], view);
    }
    for (std::size_t i = 0; i < open.size(); ++i) {
      means.add(states[i]);
      const Eigen::MatrixXd found = means.take_by_neighbours().colwise() - truth;
      const int block = paths.first / block_lanes, lane = paths.first % block_lanes;
      runs[static_cast<std::size_t>(open[i])].means.middleCols((block * looks + look) * block_lanes + lane,
                                                               found.cols()) = found;
    }
  }
}

void run_paths(const context& c, const attractor_frame& f, const time_course& course, int block,
               std::span<const int> open, std::vector<scheme_run>& runs, const path_listener& hear) {
  constexpr int in_group = block_lanes / bodies;
  const bool areas =
      std::ranges::any_of(open, [&](int k) { return runs[static_cast<std::size_t>(k)].scheme->needs_areas; });
  const int first = block * block_lanes;
  const auto all = shared_increments::of_block(*c.subject.model, c.seed, course.steps(), f.dt, areas, fast_noise(c),
                                               static_cast<std::uint64_t>(first));
  for (int lane = 0; lane < block_lanes; ++lane)
    hear(first + lane, all[static_cast<std::size_t>(lane)].view(0, static_cast<int>(course.steps())));
  for (int lane = 0; lane < block_lanes; lane += in_group)
    run_group(c, f, course, {first + lane, std::span(all).subspan(static_cast<std::size_t>(lane), in_group)}, open,
              runs);
}

void report_slope(const own_law& own, const Eigen::MatrixXd& means, std::uint64_t seed, recorder& record) {
  const quantity what{"distance to the true law", "density", "of the uniform density", "sampled"};
  const double bias = own.bias.norm();
  const auto d = distances_of(means, looks, bias);
  const auto fit = slope_over_paths(d, seed);
  curve over_paths{what, "noise paths", "1"};
  for (std::size_t i = 0; i < d.paths.size(); ++i) over_paths.add(d.paths[i], d.value[i], d.low[i], d.high[i]);
  auto exact = what;
  exact.method = "transfer";
  const std::vector evidence{record.series(over_paths, fit),
                             record.value(exact, bias, bias - own.uncertainty, bias + own.uncertainty)};
  report::verdict v{.expected = -0.5, .reason = "fewer than four usable levels"};
  if (fit) {
    v.estimate = fit->order;
    v.low = fit->low;
    v.high = fit->high;
    v.kind = judge(-0.5, fit->low, fit->high, order_margin);
    v.reason = fmt::format("slope {:.3f} [{:.3f}, {:.3f}] against -0.5 +- {:g}, the bias {:.2e} taken off", fit->order,
                           fit->low, fit->high, order_margin, bias);
  }
  record.verdict("slope over noise paths", v, evidence);
}

void report_mean(const own_law& own, const grand_mean& mean, const sample_size& size, recorder& record) {
  const double error = mean.error + own.uncertainty, off = (mean.value - own.bias).norm();
  const interval_estimate d{off, std::max(0.0, off - error), off + error};
  const auto written = record.value({"distance to its own law", "density", "of the uniform density", "sampled"}, d);
  record.verdict(
      average_claim,
      judge_distance(d, mean_bound,
                     fmt::format("{:.4f} in [{:.4f}, {:.4f}] from the scheme's own exact law, bound {:g}; from the "
                                 "true law {:.4f}, exactly {:.4f}; {}",
                                 d.value, d.low, d.high, mean_bound, mean.value.norm(), own.bias.norm(), size.text())),
      {written});
}

std::vector<scheme_run> prepared(const context& c, const attractor_frame& f, int paths) {
  std::vector<scheme_run> runs(f.schemes.size());
  parallel_for(c.threads, static_cast<int>(runs.size()), [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    const auto& scheme = f.schemes[k];
    runs[k] = {&scheme, scheme.make(f.dt), own_law_of(c, f, scheme),
               Eigen::MatrixXd(harmonic_count(moment_degree) - 1, looks * paths)};
  });
  return runs;
}

}  // namespace

void report_averages(const context& c, const attractor_frame& f, noise_log& log, report::results& out) {
  const double wait = -std::log(start_forgotten) / f.gap;
  const time_course course{f.steps_in(wait, f.dt), f.steps_in(wait / between_looks, f.dt)};
  sampling_plan plan{least_noise_paths, by_effort(c.effort, 5120, 20'480, 81'920)};
  const double most = affordable(c.effort, most_average_steps);
  const auto work = [&] { return 1.0 * bodies * static_cast<double>(course.steps()) * plan.most; };
  while (work() > most && plan.most > least_noise_paths) plan.most /= 2;
  if (!affords(c, f.schemes,
               {"attractor", average_claim, "forgetting the start", "path-steps a scheme", work(),
                [](effort e) { return affordable(e, most_average_steps); }},
               out))
    return;
  auto runs = prepared(part_of(c, 0, 0), f, plan.most);
  std::vector<grand_mean> found(runs.size());
  // One look remembers the one before by so much at most: the variance of a mean of many is (1 + r) / (1 - r) as large.
  const double r = std::pow(start_forgotten, 1.0 / between_looks), correlated = std::sqrt((1 + r) / (1 - r));
  const auto part = log.open({"averages"}, blocks_of(plan.most));
  const auto hear = [&](int path, const increment_view& v) { log.add_path(path, v, f.dt, part); };
  const auto sizes = sample_until_tight(
      part_of(c, 0.2, 1), plan, static_cast<int>(runs.size()),
      [&](int block, std::span<const int> open) { run_paths(c, f, course, block, open, runs, hear); },
      [&](int scheme, int paths) {
        const auto k = static_cast<std::size_t>(scheme);
        found[k] = mean_of(runs[k].means.leftCols(looks * paths), c.seed);
        found[k].error *= correlated;
        return found[k].error <= tight_mean * mean_bound;
      });
  for (std::size_t k = 0; k < runs.size(); ++k) {
    recorder record("attractor", runs[k].scheme->info.name, out);
    report_slope(runs[k].own, runs[k].means.leftCols(looks * sizes[k].used), c.seed, record);
    report_mean(runs[k].own, found[k], sizes[k], record);
  }
}

}  // namespace polhode
