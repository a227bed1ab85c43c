// SPDX-License-Identifier: Apache-2.0
#include "experiments/weak/weak_alone.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "ensemble/noise/paths.hpp"
#include "ensemble/orbit_start.hpp"
#include "experiments/common/judge.hpp"
#include "experiments/common/levels.hpp"
#include "experiments/common/recorder.hpp"
#include "experiments/common/sequential.hpp"
#include "experiments/weak/common_error.hpp"
#include "experiments/weak/exact_means.hpp"
#include "experiments/weak/true_means.hpp"
#include "experiments/weak/weak_sampled.hpp"
#include "problem/observables.hpp"
#include "statistics/noise/noise_audit.hpp"
#include "statistics/orders/order_fit.hpp"

namespace polhode {
namespace {

constexpr double interval = 1.96, margin = 0.02;
constexpr int chunk = 16;

struct known_mean {
  observable of;
  double exact, size;
};

/// Root mean square over a block of states all over the orbit.
double size_on_orbit(const subject& s, const observable& f) {
  const auto states = orbit_start(*s.model, s.scene.momentum).block(1, 0);
  double sum = 0;
  for (int lane = 0; lane < block_lanes; ++lane)
    sum += std::pow(f.value(lane_of(states, lane, s.model->dimension())), 2) / block_lanes;
  return std::sqrt(sum);
}

std::vector<known_mean> known_means_of(const subject& s, report::results& out) {
  std::vector<known_mean> known;
  if (s.sphere()) {
    const auto t = true_means_of(s, out);
    for (std::size_t i = 0; i < t.columns.size(); ++i)
      known.push_back(
          {{t.columns[i].observable, *observable_of(s, t.columns[i].observable)}, t.exact[i], t.columns[i].scale});
    return known;
  }
  const auto all = observables_of(s, 6);
  const auto exact = exact_means_of(s, all, s.scene.horizon);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (exact.of[i].converged()) known.push_back({all[i], *exact.of[i].value, size_on_orbit(s, all[i])});
  return known;
}

/// Everything that is sampled of one scheme.
struct sampled_scheme {
  std::vector<std::unique_ptr<kernel>> kernels;  ///< by level
  std::vector<squared_errors> differences;       ///< by observable: path, level
};

void run_block(const context& c, const level_grid& grid, const std::vector<known_mean>& known, int block,
               sampled_scheme& s) {
  const auto& m = *c.subject.model;
  increment_buffer noise(m, chunk, false, {c.generator, noise_quality::fast});
  const auto dt = grid.dt();
  for (std::size_t l = 0; l < dt.size(); ++l) {
    auto states = replicated(c.subject.scene.momentum);
    const auto path = (static_cast<std::uint64_t>(l + 1) << 40) + static_cast<std::uint64_t>(block) * block_lanes;
    for (int step = 0; step < grid.steps[l]; step += chunk) {
      const int n = std::min(chunk, static_cast<int>(grid.steps[l]) - step);
      s.kernels[l]->advance(states, noise.fill(c.seed, path, static_cast<std::uint64_t>(step), n, dt[l]));
    }
    for (int lane = 0; lane < block_lanes; ++lane) {
      const auto mu = lane_of(states, lane, m.dimension());
      for (std::size_t f = 0; f < known.size(); ++f)
        s.differences[f].at(block * block_lanes + lane, static_cast<int>(l)) = known[f].of.value(mu) - known[f].exact;
    }
  }
}

/// a of d = a + b dt^p + c dt^(p+1), c where there are levels enough.
mean_and_error limit_of(const std::vector<double>& dt, const squared_errors& d, double order) {
  const auto levels = static_cast<Eigen::Index>(dt.size());
  const Eigen::Index terms = levels > 4 ? 3 : 2;
  Eigen::MatrixXd design(levels, terms);
  Eigen::VectorXd mean(levels);
  for (Eigen::Index l = 0; l < levels; ++l) {
    const auto m = level_mean(d, static_cast<int>(l));
    const double weight = 1 / std::max(m.error, 1e-300), h = dt[static_cast<std::size_t>(l)];
    design(l, 0) = weight;
    for (Eigen::Index k = 1; k < terms; ++k) design(l, k) = weight * std::pow(h, order + static_cast<double>(k - 1));
    mean[l] = weight * m.mean;
  }
  const Eigen::MatrixXd covariance = (design.transpose() * design).inverse();
  return {(covariance * (design.transpose() * mean))[0], std::sqrt(covariance(0, 0))};
}

std::vector<mean_and_error> limits_of(const std::vector<double>& dt, const sampled_scheme& s, double order) {
  std::vector<mean_and_error> out;
  for (const auto& d : s.differences) out.push_back(limit_of(dt, d, order));
  return out;
}

report::verdict judge_limits(const std::vector<known_mean>& known, const std::vector<mean_and_error>& limits) {
  std::size_t worst = 0;
  double furthest = 0, widest = 0;
  bool finite = true;
  for (std::size_t f = 0; f < known.size(); ++f) {
    const double z = std::fabs(limits[f].mean) / limits[f].error;
    finite = finite && std::isfinite(z);
    if (z > furthest) {
      furthest = z;
      worst = f;
    }
    widest = std::max(widest, (std::fabs(limits[f].mean) + interval * limits[f].error) / known[f].size);
  }
  report::verdict v{.expected = 0.0};
  if (!finite) {
    v.kind = report::verdict_kind::refuted;
    v.reason = "a path was lost: not finite";
    return v;
  }
  const double size = known[worst].size;
  v.estimate = limits[worst].mean / size;
  v.low = *v.estimate - interval * limits[worst].error / size;
  v.high = *v.estimate + interval * limits[worst].error / size;
  const double allowed = audit_threshold(known.size());
  v.kind = furthest > allowed ? report::verdict_kind::refuted
           : widest <= margin ? report::verdict_kind::holds
                              : report::verdict_kind::inconclusive;
  v.reason = fmt::format(
      "at dt -> 0 E[{}] is left with {:.2g} of its size, {:.1f} standard errors, at most {:.1f}; all stay within "
      "{:.2g}, "
      "bound {:g}",
      known[worst].of.name, *v.estimate, furthest, allowed, widest, margin);
  return v;
}

void report_one(const context& c, const level_grid& grid, const std::vector<known_mean>& known,
                const scheme_entry& scheme, double order, sampled_scheme& s, const sample_size& size,
                report::results& out) {
  recorder record("weak", scheme.info.name, out);
  const auto dt = grid.dt();
  std::vector<double> sizes;
  for (auto& d : s.differences) d.paths = size.used;
  for (std::size_t f = 0; f < known.size(); ++f) {
    sizes.push_back(known[f].size);
    curve one{{sampled_error, known[f].of.name, "", "sampled"}};
    for (int l = 0; l < s.differences[f].levels; ++l) {
      const auto m = level_mean(s.differences[f], l);
      one.add(dt[static_cast<std::size_t>(l)], std::fabs(m.mean), std::fabs(m.mean) - interval * m.error,
              std::fabs(m.mean) + interval * m.error);
    }
    record.series(one);
  }
  const auto together = along_their_errors(s.differences, sizes, clear_error);
  const auto fit = fit_order_of_clear_means(dt, together, clear_error, c.seed);
  curve all{{sampled_error, all_together, "1", "sampled"}};
  for (int l = 0; l < together.levels; ++l) {
    const auto m = level_mean(together, l);
    all.add(dt[static_cast<std::size_t>(l)], std::fabs(m.mean), std::fabs(m.mean) - interval * m.error,
            std::fabs(m.mean) + interval * m.error);
  }
  const auto written = record.series(all, fit);
  auto v = judge_order(order, fit, true);
  v.reason += "; sampled by random numbers of its own, " + size.text();
  record.verdict(weak_order_claim, v, {written});
  record.verdict(right_means_claim, judge_limits(known, limits_of(dt, s, order)), {written});
}

}  // namespace

void report_orders_alone(const context& c, const std::function<double(const scheme_entry&)>& expected,
                         report::results& out) {
  const auto known = known_means_of(c.subject, out);
  if (known.empty()) {
    for (const auto& e : c.subject.schemes)
      out.skipped.push_back(
          {"weak", std::string(e.info.name), "draws random numbers of its own, and no mean is known exactly here"});
    return;
  }
  const auto grid = scene_levels(c.subject);
  const sampling_plan plan{1 << 14, by_effort(c.effort, 1 << 16, 1 << 18, 1 << 19)};
  const auto orders = [&](const scheme_entry& e) { return expected(e) > 0 ? expected(e) : 1; };
  std::vector<sampled_scheme> all(c.subject.schemes.size());
  for (std::size_t k = 0; k < all.size(); ++k) {
    for (const double dt : grid.dt()) all[k].kernels.push_back(c.subject.schemes[k].make(dt));
    const int levels = static_cast<int>(grid.steps.size()), paths = blocks_of(plan.most) * block_lanes;
    all[k].differences.assign(
        known.size(), {paths, levels, std::vector<double>(static_cast<std::size_t>(paths) * grid.steps.size())});
  }
  const auto sizes = sample_until_tight(
      c, plan, static_cast<int>(all.size()),
      [&](int block, std::span<const int> open) {
        for (const int k : open) run_block(c, grid, known, block, all[static_cast<std::size_t>(k)]);
      },
      [&](int scheme, int so_far) {
        auto& s = all[static_cast<std::size_t>(scheme)];
        for (auto& d : s.differences) d.paths = so_far;
        const auto limits = limits_of(grid.dt(), s, orders(c.subject.schemes[static_cast<std::size_t>(scheme)]));
        double widest = 0;
        for (std::size_t f = 0; f < known.size(); ++f) widest = std::max(widest, limits[f].error / known[f].size);
        return interval * widest <= margin / 8;
      });
  for (std::size_t k = 0; k < all.size(); ++k)
    report_one(c, grid, known, c.subject.schemes[k], orders(c.subject.schemes[k]), all[k], sizes[k], out);
}

}  // namespace polhode
