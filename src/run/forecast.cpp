// SPDX-License-Identifier: Apache-2.0
#include "run/forecast.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/levels.hpp"
#include "platform/denormals.hpp"
#include "run/cache_key.hpp"
#include "run/foreign_runs.hpp"
#include "run/machine_options.hpp"

namespace polhode {
namespace {

using clock = std::chrono::steady_clock;

/// Seconds of a step of one path by scheme, measured when it is first asked for.
class step_prices {
 public:
  step_prices(const subject& s, const verify_options& options) : s_(s), options_(options) {}

  double of(const scheme_entry& scheme) {
    const auto [found, is_new] = known_.try_emplace(scheme.info.name, 0);
    if (is_new) found->second = measured(scheme);
    return found->second;
  }

 private:
  /// Of one of our own the quickest of a few runs; of an integrator from elsewhere as it was tried.
  double measured(const scheme_entry& scheme) {
    constexpr int steps = 8, runs = 3;  // a first one meets cold memory, another may be interrupted
    if (const auto* of = find_foreign(options_.foreign, scheme.info.name)) return 1e-9 * of->cost();
    const flush_denormals flushed;
    const double dt = finest_step(s_);
    increment_buffer noise(*s_.model, steps, scheme.needs_areas,
                           {generator_named(options_.generator), noise_quality::fast});
    const auto view = s_.model->layout().silent() ? silence(steps) : noise.fill(options_.seed, 0, 0, steps, dt);
    const auto stepper = scheme.make(dt);
    double quickest = HUGE_VAL;
    for (int run = 0; run < runs; ++run) {
      auto states = replicated(s_.scene.momentum);
      const auto begun = clock::now();
      stepper->advance(states, view);
      quickest = std::min(quickest, std::chrono::duration<double>(clock::now() - begun).count());
    }
    return quickest / (steps * block_lanes);
  }

  const subject& s_;
  const verify_options& options_;
  std::map<std::string_view, double> known_;
};

bool is_kept(const context& c, const experiment& e, std::string_view scheme, const verify_options& options) {
  if (options.store == nullptr || !e.kept || find_foreign(options.foreign, scheme) != nullptr) return false;
  const auto key = cache_key(c, e.info.name, scheme);
  return !key.empty() && options.store->may_hold(key);
}

void add_costs(const experiment& e, const context& c, step_prices& prices, const verify_options& options,
               std::vector<scheme_cost>& out) {
  report::results unread;
  for (const auto& part : parts_for(e, c.subject, options.foreign, unread)) {
    const auto work = part.experiment.work(part.subject, c.effort);
    for (const auto& scheme : part.subject.schemes)
      if (!is_kept(c, e, scheme.info.name, options))
        out.push_back({e.info.name, std::string(scheme.info.name), work.path_steps * prices.of(scheme) + work.seconds});
  }
}

}  // namespace

std::vector<scheme_cost> scheme_costs(const subject& s, std::span<const experiment> experiments,
                                      const verify_options& options) {
  step_prices prices(s, options);
  const context c{s, options.effort, options.threads, options.seed, generator_named(options.generator)};
  std::vector<scheme_cost> out;
  for (const auto& e : experiments)
    if (!e.skip_reason(s)) add_costs(e, c, prices, options, out);
  return out;
}

std::vector<expected_cost> forecast(std::span<const experiment> experiments, std::span<const scheme_cost> costs) {
  std::vector<expected_cost> out;
  for (const auto& e : experiments) {
    double seconds = 0;
    for (const auto& one : costs)
      if (one.experiment == e.info.name) seconds += one.cpu_seconds;
    out.push_back({e.info.name, seconds});
  }
  return out;
}

}  // namespace polhode
