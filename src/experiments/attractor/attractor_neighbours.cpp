// SPDX-License-Identifier: Apache-2.0
// Neighbours under one noise meet where lambda_1 < 0, so that all bodies end in one random point, and part where
// lambda_1 > 0: at the rate lambda_1?
//
// Bodies in pairs at a tiny distance, under the noise of many paths: the mean of log(distance) over a long time, once
// directions have forgotten their start, grows by lambda_1 a unit of time. One pair a path: rates differ between paths
// far more than between pairs of one path. So a lane is a path, and a block of first bodies and one of second ones see
// the same block of noise.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "ensemble/noise/paths.hpp"
#include "ensemble/uniform_start.hpp"
#include "experiments/attractor/attractor.hpp"
#include "experiments/common/sequential.hpp"
#include "experiments/common/undecided.hpp"

namespace polhode {
namespace {

constexpr double close = 1e-6;                 // of the radius: small against the sphere, large against rounding
constexpr double folds = 3;                    // where they meet, the distance falls by exp(3) on the way
constexpr double contractions = 10;            // where they part, areas fall by about exp(10)
constexpr double directions_forgotten = 1e-3;  // of the start, before the clock runs
constexpr double rate_margin = 0.05;  // of |lambda_2|: at so coarse a step a scheme of order one is off by that
constexpr double tight_exponent = 0.5;
constexpr double most_steps = 10'000;

/// What is asked, and where it is written.
struct neighbour_words {
  const char *claim, *quantity, *part;
};
neighbour_words words_of(double lambda1) {
  if (lambda1 < 0) return {"collapse at the rate lambda_1", "collapse rate", "collapse"};
  return {"neighbours part at the rate lambda_1", "parting rate", "neighbours"};
}

struct clock {
  double dt;
  std::int64_t piece, before, measured;  ///< steps of a piece; pieces before the clock runs, and while it does
  std::int64_t steps() const { return piece * (before + measured); }
  double time() const { return static_cast<double>(piece * measured) * dt; }
};

clock clock_of(const attractor_frame& f) {
  clock t{f.dt / 4, 0, 0, 0};
  t.piece = f.steps_in(-1 / f.lambda2(), t.dt);
  const double piece = static_cast<double>(t.piece) * t.dt;
  t.before = f.steps_in(-std::log(directions_forgotten) / f.gap, piece);
  const double lambda1 = *f.exponents.lambda1;
  t.measured = f.steps_in(lambda1 < 0 ? -folds / lambda1 : -contractions / f.lambda2(), piece);
  return t;
}

using chunk_listener = std::function<void(const increment_view&)>;

/// Two bodies a noise path, which is a lane.
struct pairs {
  std::vector<double> first, second;
};

/// Moves each second body towards its first until they are close, on the sphere.
void bring_together(double radius, pairs& p) {
  for (std::size_t lane = 0; lane < block_lanes; ++lane) {
    std::array<double, 3> to{};
    double apart = 0, size = 0;
    for (std::size_t k = lane; k < p.first.size(); k += block_lanes)
      apart = std::hypot(apart, p.second[k] - p.first[k]);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = k * block_lanes + lane;
      to[k] = p.first[at] + close * radius * (p.second[at] - p.first[at]) / apart;
      size = std::hypot(size, to[k]);
    }
    for (std::size_t k = 0; k < 3; ++k) p.second[k * block_lanes + lane] = radius * to[k] / size;
  }
}

/// Adds factor times the logarithm of their distance, path by path.
void add_log_distance(const pairs& p, double factor, std::span<double> sums) {
  for (std::size_t lane = 0; lane < block_lanes; ++lane) {
    double square = 0;
    for (std::size_t k = lane; k < p.first.size(); k += block_lanes) square += std::pow(p.second[k] - p.first[k], 2);
    sums[lane] += factor * 0.5 * std::log(square);
  }
}

/// Pieces after which the pairs are brought together again: no distance grows to the size of the sphere, or falls to
/// rounding (Benettin et al., Meccanica 15 (1980) 9). Rates by scheme and path; all schemes see the same noise.
class neighbours_block {
 public:
  neighbours_block(const context& c, const attractor_frame& f, const clock& t, int block)
      : context_(c),
        radius_(f.problem.radius),
        clock_(t),
        first_path_(static_cast<std::uint64_t>(block) * block_lanes) {}

  /// kernels, rates: of the schemes that run.
  void run(std::span<const kernel* const> kernels, bool with_areas, std::span<const std::span<double>> rates,
           const chunk_listener& hear) {
    increment_buffer noise(*context_.subject.model, chunk, with_areas, fast_noise(context_));
    std::vector<pairs> bodies(kernels.size(), started());
    for (const auto& r : rates) std::ranges::fill(r, 0.0);
    for (std::int64_t i = 0; i < clock_.before + clock_.measured; ++i) {
      for (auto& p : bodies) bring_together(radius_, p);
      if (i >= clock_.before) add(-1, bodies, rates);
      advance(i * clock_.piece, kernels, noise, bodies, hear);
      if (i >= clock_.before) add(1, bodies, rates);
    }
  }

 private:
  static constexpr int chunk = 16;  // steps whose noise stays in the nearest cache

  pairs started() const {
    return {uniform_states(context_.seed, 2 * first_path_, radius_),
            uniform_states(context_.seed, 2 * first_path_ + block_lanes, radius_)};
  }
  void add(int sign, const std::vector<pairs>& bodies, std::span<const std::span<double>> rates) const {
    for (std::size_t k = 0; k < bodies.size(); ++k) add_log_distance(bodies[k], sign / clock_.time(), rates[k]);
  }
  void advance(std::int64_t first_step, std::span<const kernel* const> kernels, increment_buffer& noise,
               std::vector<pairs>& bodies, const chunk_listener& hear) const {
    for (std::int64_t i = 0; i < clock_.piece; i += chunk) {
      const auto n = static_cast<int>(std::min<std::int64_t>(chunk, clock_.piece - i));
      const auto view =
          noise.fill(context_.seed, first_path_, static_cast<std::uint64_t>(first_step + i), n, clock_.dt);
      hear(view);
      for (std::size_t k = 0; k < kernels.size(); ++k) {
        kernels[k]->advance(bodies[k].first, view);
        kernels[k]->advance(bodies[k].second, view);
      }
    }
  }

  const context& context_;
  double radius_;
  const clock& clock_;
  std::uint64_t first_path_;
};

report::verdict judge_exponent(const clock& t, const interval_estimate& found, double exact, double margin) {
  if (!std::isfinite(found.value)) return {.expected = exact, .reason = "bodies were lost: not finite"};
  report::verdict v{.expected = exact, .estimate = found.value, .low = found.low, .high = found.high};
  v.kind = judge(exact, found.low, found.high, margin);
  if (v.kind == report::verdict_kind::holds && exact < 0 && found.high >= 0)
    v.kind = report::verdict_kind::inconclusive;
  v.reason = fmt::format(
      "{:.5f} [{:.5f}, {:.5f}] against lambda_1 = {:.5f} +- {:.2g} (a twentieth of |lambda_2|), over a time of {:.3g} "
      "at dt = {:.4g}",
      found.value, found.low, found.high, exact, margin, t.time(), t.dt);
  return v;
}

}  // namespace

void report_neighbours(const context& c, const attractor_frame& f, noise_log& log, report::results& out) {
  const double exact = *f.exponents.lambda1, margin = rate_margin * -f.lambda2();
  const auto words = words_of(exact);
  const auto t = clock_of(f);
  const std::int64_t steps = t.steps();
  if (!affords(c, f.schemes,
               {"attractor", words.claim, fmt::format("lambda_1 = {:.2e}", exact), "steps", static_cast<double>(steps),
                [](effort) { return most_steps; }},
               out))
    return;
  const sampling_plan plan{1024, by_effort(c.effort, 2048, 16'384, 65'536)};
  const auto most = static_cast<std::size_t>(blocks_of(plan.most) * block_lanes);
  std::vector<std::vector<double>> rates(f.schemes.size(), std::vector<double>(most));
  std::vector<std::unique_ptr<kernel>> kernels;
  for (const auto& scheme : f.schemes) kernels.push_back(scheme.make(t.dt));
  const auto part = log.open({words.part}, blocks_of(plan.most));
  const auto run_block = [&](int block, std::span<const int> open) {
    std::vector<const kernel*> steppers;
    std::vector<std::span<double>> found;
    bool areas = false;
    for (const int scheme : open) {
      const auto k = static_cast<std::size_t>(scheme);
      steppers.push_back(kernels[k].get());
      found.push_back(std::span(rates[k]).subspan(static_cast<std::size_t>(block) * block_lanes, block_lanes));
      areas = areas || f.schemes[k].needs_areas;
    }
    neighbours_block(c, f, t, block).run(steppers, areas, found, [&](const increment_view& v) {
      log.add(block, v, t.dt, part);
    });
  };
  const auto so_far = [&](std::size_t k, int paths) { return std::vector(rates[k].begin(), rates[k].begin() + paths); };
  const auto sizes =
      sample_until_tight(c, plan, static_cast<int>(f.schemes.size()), run_block, [&](int scheme, int paths) {
        const auto found = mean_interval(so_far(static_cast<std::size_t>(scheme), paths));
        return half_width(found) <= tight_exponent * margin;
      });
  for (std::size_t k = 0; k < f.schemes.size(); ++k) {
    recorder record("attractor", f.schemes[k].info.name, out);
    const auto found = mean_interval(so_far(k, sizes[k].used));
    const auto written = record.value({words.quantity, "", "per time", "sampled"}, found);
    record.verdict(words.claim, judge_exponent(t, found, exact, margin), {written});
    record.remark(sizes[k].text());
  }
}

}  // namespace polhode
