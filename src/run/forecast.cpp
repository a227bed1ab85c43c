// SPDX-License-Identifier: Apache-2.0
#include "run/forecast.hpp"

#include <algorithm>
#include <chrono>
#include <map>
#include <utility>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/levels.hpp"
#include "platform/denormals.hpp"
#include "run/cache_key.hpp"
#include "run/foreign_runs.hpp"
#include "run/machine_options.hpp"

namespace polhode {
namespace {

using clock = std::chrono::steady_clock;

/// Seconds of a step of one path, by the scheme; of an integrator from elsewhere as it was tried.
std::map<std::string_view, double> prices_of(const subject& s, const verify_options& options) {
  constexpr int steps = 8, runs = 3;  // a first one meets cold memory, another may be interrupted
  const flush_denormals flushed;
  const double dt = finest_step(s);
  increment_buffer noise(*s.model, steps, any_needs_areas(s.schemes),
                         {generator_named(options.generator), noise_quality::fast});
  const auto view = s.model->layout().silent() ? silence(steps) : noise.fill(options.seed, 0, 0, steps, dt);
  std::map<std::string_view, double> out;
  for (const auto& scheme : s.schemes) {
    double& price = out[scheme.info.name];
    if (const auto* of = find_foreign(options.foreign, scheme.info.name)) {
      price = 1e-9 * of->cost();
      continue;
    }
    const auto stepper = scheme.make(dt);
    for (int run = 0; run < runs; ++run) {
      auto states = replicated(s.scene.momentum);
      const auto begun = clock::now();
      stepper->advance(states, view);
      const double seconds = std::chrono::duration<double>(clock::now() - begun).count() / (steps * block_lanes);
      price = run == 0 ? seconds : std::min(price, seconds);
    }
  }
  return out;
}

bool is_kept(const context& c, const experiment& e, std::string_view scheme, const verify_options& options) {
  if (options.store == nullptr || !e.kept || find_foreign(options.foreign, scheme) != nullptr) return false;
  const auto key = cache_key(c, e.info.name, scheme);
  return !key.empty() && options.store->may_hold(key);
}

double cost_of(const experiment& e, const context& c, const std::map<std::string_view, double>& prices,
               const verify_options& options) {
  report::results unread;
  double seconds = 0;
  for (const auto& part : parts_for(e, c.subject, options.foreign, unread)) {
    const auto work = part.experiment.work(part.subject, c.effort);
    for (const auto& scheme : part.subject.schemes)
      if (!is_kept(c, e, scheme.info.name, options))
        seconds += work.path_steps * prices.at(scheme.info.name) + work.seconds;
  }
  return seconds;
}

}  // namespace

std::vector<expected_cost> forecast(const subject& s, std::span<const experiment> experiments,
                                    const verify_options& options) {
  const auto prices = prices_of(s, options);
  const context c{s, options.effort, options.threads, options.seed, generator_named(options.generator)};
  std::vector<expected_cost> out;
  for (const auto& e : experiments) out.push_back({e.info.name, e.skip_reason(s) ? 0 : cost_of(e, c, prices, options)});
  return out;
}

}  // namespace polhode
