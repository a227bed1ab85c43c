// SPDX-License-Identifier: Apache-2.0
#include "experiments/gibbs/gibbs_moments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/judge.hpp"

namespace polhode {
namespace {

constexpr double uniform_deviation = 0.298;  // of Pi_k^2 / c^2 on the uniform sphere: sqrt(4/45)
constexpr double tight_moments = 1.0 / 3;    // of a margin: the half-width at which sampling stops

}  // namespace

report::verdict judge_mean(double exact, double margin, const interval_estimate& m) {
  if (!std::isfinite(m.value)) return {.expected = exact, .reason = "paths were lost: not finite"};
  return {.expected = exact,
          .estimate = m.value,
          .low = m.low,
          .high = m.high,
          .kind = judge(exact, m.low, m.high, margin),
          .reason = fmt::format("[{:.6f}, {:.6f}] against {:.6f} +- {:.2g} (a tenth of a standard deviation)", m.low,
                                m.high, exact, margin)};
}

void observe(const model& m, std::span<const double> states, int block, path_means& out) {
  for (int lane = 0; lane < block_lanes; ++lane) {
    const auto mu = lane_of(states, lane, m.dimension());
    const auto path = static_cast<std::size_t>(block * block_lanes + lane);
    const double h = m.energy(mu);
    out.energy[path] += h / observations;
    out.energy2[path] += h * h / observations;
    out.square1[path] += mu[0] * mu[0] / observations;
    out.square3[path] += mu[2] * mu[2] / observations;
    out.last_energy[path] = h;
  }
}

std::vector<gibbs_moment> moments_of(const gibbs_law& law, double radius) {
  const double deviation = std::sqrt(law.energy_variance()), mean = law.mean_energy();
  // Of h^2: where the mean is small against the deviation, that of the square of a normal number of mean 0.
  const double of_square = std::max(2 * std::fabs(mean) * deviation, std::numbers::sqrt2 * deviation * deviation);
  const double square = uniform_deviation * radius * radius;
  return {{"energy", &path_means::energy, mean, moment_margin * deviation},
          {"energy^2", &path_means::energy2, law.energy_variance() + mean * mean, moment_margin * of_square},
          {"pi1^2", &path_means::square1, law.mean_square(0), moment_margin * square},
          {"pi3^2", &path_means::square3, law.mean_square(2), moment_margin * square}};
}

gibbs_finding find(const gibbs_law& law, const std::vector<gibbs_moment>& moments, const path_means& o, int paths) {
  const auto first = [&](const std::vector<double>& v) { return std::span(v).first(static_cast<std::size_t>(paths)); };
  gibbs_finding f;
  for (const auto& m : moments) f.means.push_back(mean_interval(first(o.*m.values)));
  f.ks = ks_distance(first(o.last_energy), [&](double h) { return law.energy_cdf(h); });
  return f;
}

// The Kolmogorov-Smirnov interval reaches as far above its distance whatever that is.
bool tight(const std::vector<gibbs_moment>& moments, const gibbs_finding& f) {
  for (std::size_t i = 0; i < moments.size(); ++i)
    if (half_width(f.means[i]) > tight_moments * moments[i].margin) return false;
  return f.ks.high - f.ks.value <= tight_moments * ks_bound;
}

void report_finding(const std::vector<gibbs_moment>& moments, double dt, const gibbs_finding& f, recorder& record) {
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const auto& what = moments[i];
    const auto written = record.value({"mean", what.observable, "", "sampled"}, at_dt(dt), f.means[i]);
    record.verdict("mean of " + what.observable, judge_mean(what.exact, what.margin, f.means[i]), {written});
  }
  const auto written = record.value({"ks_distance", "energy", "", "sampled"}, at_dt(dt), f.ks);
  record.verdict("law of the energy",
                 judge_distance(f.ks, ks_bound,
                                fmt::format("Kolmogorov-Smirnov distance {:.4f} in [{:.4f}, {:.4f}], bound {:g}",
                                            f.ks.value, f.ks.low, f.ks.high, ks_bound)),
                 {written});
}

}  // namespace polhode
