// Where lambda_1 < 0 all bodies under one noise meet in one random point: at the rate lambda_1?
//
// Bodies in pairs at a tiny distance, under the noise of many paths: the mean of log(distance) over a long time, once
// directions have forgotten their start, falls at lambda_1 a unit of time.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ensemble/shared_increments.hpp"
#include "ensemble/uniform_start.hpp"
#include "experiments/attractor.hpp"
#include "experiments/sequential.hpp"
#include "experiments/undecided.hpp"

namespace polhode {
namespace {

constexpr double close = 1e-6;        // of the radius: small against the sphere, large against rounding
constexpr double folds = 3;           // the distance falls by exp(3) on the way
constexpr double forgotten = 1e-3;    // of the start, before the clock runs
constexpr double rate_margin = 0.05;  // of |lambda_2|: at so coarse a step a scheme of order one is off by that
constexpr double tight_share = 0.5;
constexpr double most_steps = 10'000;
constexpr const char* collapse_claim = "collapse at the rate lambda_1";

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
  t.before = f.steps_in(-std::log(forgotten) / f.gap, piece);
  t.measured = f.steps_in(-folds / *f.exponents.lambda1, piece);
  return t;
}

/// Moves lane 2i + 1 towards lane 2i until they are close, on the sphere.
void bring_together(double radius, std::vector<double>& states) {
  for (std::size_t lane = 0; lane < block_lanes; lane += 2) {
    std::array<double, 3> to{};
    double apart = 0, size = 0;
    const auto at = [&](std::size_t k, std::size_t body) -> double& { return states[k * block_lanes + lane + body]; };
    for (std::size_t k = 0; k < 3; ++k) apart = std::hypot(apart, at(k, 1) - at(k, 0));
    for (std::size_t k = 0; k < 3; ++k) {
      to[k] = at(k, 0) + close * radius * (at(k, 1) - at(k, 0)) / apart;
      size = std::hypot(size, to[k]);
    }
    for (std::size_t k = 0; k < 3; ++k) at(k, 1) = radius * to[k] / size;
  }
}

/// The mean over the pairs of the logarithm of their distance.
double log_distance(const std::vector<double>& states) {
  double sum = 0;
  for (std::size_t lane = 0; lane < block_lanes; lane += 2) {
    double square = 0;
    for (std::size_t k = 0; k < 3; ++k)
      square += std::pow(states[k * block_lanes + lane + 1] - states[k * block_lanes + lane], 2);
    sum += 0.5 * std::log(square);
  }
  return sum / (block_lanes / 2);
}

/// Pieces after which the pairs are brought together again: no distance grows to the size of the sphere, or falls to
/// rounding (Benettin et al., Meccanica 15 (1980) 9).
double rate_along(const kernel& k, const shared_steps& noise, const clock& t, double radius,
                  std::vector<double>& states) {
  double sum = 0;
  for (std::int64_t i = 0; i < t.before + t.measured; ++i) {
    bring_together(radius, states);
    const double before = log_distance(states);
    k.advance(states, noise, i * t.piece, t.piece);
    if (i >= t.before) sum += log_distance(states) - before;
  }
  return sum / t.time();
}

void report_rate(const std::string& name, const clock& t, const std::vector<double>& rates, double exact, double margin,
                 report::results& out) {
  const auto found = mean_interval(rates);
  out.measurements.push_back(measured({"attractor", name, "collapse rate", "", "per time", "sampled"}, {}, found.value,
                                      found.low, found.high));
  report::verdict v{"attractor", name,      collapse_claim, exact,
                    found.value, found.low, found.high,     judge(exact, found.low, found.high, margin),
                    ""};
  v.reason = fmt::format(
      "{:.5f} [{:.5f}, {:.5f}] against lambda_1 = {:.5f} +- {:.2g} (a twentieth of |lambda_2|), over a time of {:.3g} "
      "at dt = {:.4g}",
      found.value, found.low, found.high, exact, margin, t.time(), t.dt);
  if (v.kind == report::verdict_kind::holds && found.high >= 0) v.kind = report::verdict_kind::inconclusive;
  if (!std::isfinite(found.value)) {
    v.estimate = v.low = v.high = std::nullopt;
    v.reason = "bodies were lost: not finite";
  }
  out.verdicts.push_back(v);
}

}  // namespace

void report_collapse(const context& c, const attractor_frame& f, noise_log& log, report::results& out) {
  const double exact = *f.exponents.lambda1, margin = rate_margin * -f.lambda2();
  const auto t = clock_of(f);
  const std::int64_t steps = t.steps();
  if (!affords(c, f.schemes,
               {"attractor", collapse_claim, fmt::format("lambda_1 = {:.2e}", exact), "steps",
                static_cast<double>(steps), [](effort) { return most_steps; }},
               out))
    return;
  const sampling_plan plan{512, by_effort(c.effort, 1024, 8192, 32'768)};
  const auto most = static_cast<std::size_t>(blocks_of(plan.most) * block_lanes);
  std::vector<std::vector<double>> rates(f.schemes.size(), std::vector<double>(most));
  std::vector<std::unique_ptr<kernel>> kernels;
  for (const auto& scheme : f.schemes) kernels.push_back(scheme.make(t.dt));
  const auto part = log.open({"collapse"}, blocks_of(plan.most));
  const auto run_path = [&](std::uint64_t path, const shared_increments& drawn, std::span<const int> open) {
    log.add_path(static_cast<int>(path), drawn.view(0, static_cast<int>(steps)), part);
    std::vector<double> start(3 * block_lanes), states;
    start_uniformly(c.seed, path * block_lanes, f.problem.radius, start);
    for (const int scheme : open) {
      const auto k = static_cast<std::size_t>(scheme);
      const auto noise = kernels[k]->share(drawn.view(0, static_cast<int>(steps)));
      states = start;
      rates[k][static_cast<std::size_t>(path)] = rate_along(*kernels[k], noise, t, f.problem.radius, states);
    }
  };
  const auto so_far = [&](std::size_t k, int paths) { return std::vector(rates[k].begin(), rates[k].begin() + paths); };
  const auto sizes = sample_until_tight(
      c, plan, static_cast<int>(f.schemes.size()),
      [&](int block, std::span<const int> open) {
        const bool areas =
            std::ranges::any_of(open, [&](int k) { return f.schemes[static_cast<std::size_t>(k)].needs_areas; });
        const auto first = static_cast<std::uint64_t>(block) * block_lanes;
        const auto drawn =
            shared_increments::of_block(*c.subject.model, c.seed, steps, t.dt, areas, fast_noise(c), first);
        for (std::uint64_t i = 0; i < block_lanes; ++i) run_path(first + i, drawn[i], open);
      },
      [&](int scheme, int paths) {
        const auto found = mean_interval(so_far(static_cast<std::size_t>(scheme), paths));
        return half_width(found) <= tight_share * margin;
      });
  for (std::size_t k = 0; k < f.schemes.size(); ++k) {
    report_rate(std::string(f.schemes[k].info.name), t, so_far(k, sizes[k].used), exact, margin, out);
    out.verdicts.back().reason += "; " + sizes[k].text();
  }
}

}  // namespace polhode
