// SPDX-License-Identifier: Apache-2.0
#include "experiments/gibbs/long_runs.hpp"

#include <algorithm>
#include <cmath>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/levels.hpp"

namespace polhode {
namespace {

constexpr double run_forgetting = 3, run_averaging = 20, apart = 0.5;  // autocorrelation times
constexpr double forgetting_of_the_pool = 10;
constexpr double most_pilot_steps = 4e5;  // of the pilot run
constexpr int pool = 16;                  // blocks
constexpr int run_chunk = 200;
constexpr std::uint64_t pilot_paths = std::uint64_t{1} << 40, pool_paths = std::uint64_t{1} << 41;

/// Advances a block; step: of its noise.
void advance(const kernel& stepper, increment_buffer& noise, std::uint64_t seed, std::uint64_t first_path,
             std::int64_t steps, std::uint64_t& step, std::vector<double>& states) {
  for (std::int64_t left = steps; left > 0; left -= run_chunk) {
    const int n = static_cast<int>(std::min<std::int64_t>(left, run_chunk));
    stepper.advance(states, noise.fill(seed, first_path, step, n, stepper.dt()));
    step += static_cast<std::uint64_t>(n);
  }
}

}  // namespace

std::optional<std::string> no_gibbs_means(const subject& s) {
  if (s.model->noise() != noise_class::isotropic) return "the noise is not isotropic: no Gibbs law is claimed for it";
  if (s.offers->gibbs_mean) return std::nullopt;
  return s.offers->no_gibbs_mean.empty() ? "the system knows no means of a Gibbs law" : s.offers->no_gibbs_mean;
}

long_runs::long_runs(const context& c, const std::vector<observable>& all) : context_(c) {
  if (const auto none = no_gibbs_means(c.subject)) {
    reason_ = *none;
    return;
  }
  const double dt = 0.04 / fastest_rate(c.subject);
  const auto found = relaxation_of(c, all, dt, most_pilot_steps, pilot_paths);
  if (!found.reason.empty()) {
    reason_ = "the start is not forgotten: " + found.reason;
    return;
  }
  time_ = found.time;
  for (std::size_t f = 0; f < all.size(); ++f) {
    const auto law = c.subject.offers->gibbs_mean(all[f].name);
    if (!law || !law->value || found.deviation[f] <= 1e-9 * (std::fabs(*law->value) + found.deviation[f])) continue;
    observables_.push_back(all[f]);
    exact_.push_back(*law->value);
    uncertainty_.push_back(law->uncertainty);
    deviation_.push_back(found.deviation[f]);
  }
  if (observables_.empty())
    reason_ = "of none of these observables is the mean under the Gibbs law known";
  else
    fill_pool(dt);
}

double long_runs::size(std::size_t f) const { return std::hypot(exact_[f], deviation_[f]); }

double long_runs::worth_of_a_path() { return run_averaging / 2; }

double long_runs::steps_of_a_path(double dt) const { return std::ceil((run_forgetting + run_averaging) * time_ / dt); }

void long_runs::fill_pool(double dt) {
  pool_.resize(pool);
  const auto equation = context_.subject.model->reference(dt);
  parallel_for(context_.threads, pool, [&](int b) {
    const auto first_path = pool_paths + static_cast<std::uint64_t>(b * block_lanes);
    increment_buffer noise(*context_.subject.model, run_chunk, false, {context_.generator, noise_quality::fast});
    auto [states, step] = spread_start(context_, dt, first_path);
    advance(*equation, noise, context_.seed, first_path,
            static_cast<std::int64_t>(std::ceil(forgetting_of_the_pool * time_ / dt)), step, states);
    pool_[static_cast<std::size_t>(b)] = std::move(states);
  });
}

void long_runs::run(const scheme_entry& scheme, double dt, std::uint64_t seed, int from, int to,
                    squared_errors& out) const {
  const auto stepper = scheme.make(dt);
  parallel_for(context_.threads, to - from,
               [&](int i) { run_block(*stepper, scheme.needs_areas, seed, from + i, out); });
}

void long_runs::run_block(const kernel& stepper, bool areas, std::uint64_t seed, int block, squared_errors& out) const {
  const int first = block * block_lanes, dimension = context_.subject.model->dimension();
  const auto steps = [&](double times) {
    return std::max<std::int64_t>(1, std::llround(times * time_ / stepper.dt()));
  };
  const std::int64_t spacing = steps(apart), looks = std::max<std::int64_t>(1, steps(run_averaging) / spacing);
  increment_buffer noise(*context_.subject.model, run_chunk, areas, {context_.generator, noise_quality::fast});
  auto states = pool_[static_cast<std::size_t>(block % pool)];
  std::uint64_t step = 0;
  for (std::int64_t look = 0; look <= looks; ++look) {
    advance(stepper, noise, seed, static_cast<std::uint64_t>(first), look == 0 ? steps(run_forgetting) : spacing, step,
            states);
    for (int lane = 0; lane < block_lanes && look > 0; ++lane) {
      const auto mu = lane_of(states, lane, dimension);
      for (std::size_t f = 0; f < observables_.size(); ++f)
        out.at(first + lane, static_cast<int>(f)) +=
            (observables_[f].value(mu) - exact_[f]) / static_cast<double>(looks);
    }
  }
}

}  // namespace polhode
