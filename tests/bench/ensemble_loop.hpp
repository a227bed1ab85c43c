// SPDX-License-Identifier: Apache-2.0
// The only place where the benches touch the laboratory's kernels: one block of paths, as an ensemble advances it.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/measure.hpp"
#include "ensemble/noise/normal_block.hpp"
#include "ensemble/noise/paths.hpp"
#include "ensemble/noise/shared_increments.hpp"
#include "ensemble/simulation.hpp"
#include "platform/isa.hpp"
#include "run/verify.hpp"

namespace polhode::bench {

inline constexpr double dt = 0.01;
inline constexpr int steps = 256, chunk = 16;  ///< of a call, and of increments drawn at a time
inline constexpr std::uint64_t seed = 1;

/// What an ensemble takes where speed is asked for: fast normals, from ARS where the processor has AES.
inline noise_source fastest_noise() {
  return {ars_usable() ? noise_generator::ars : noise_generator::philox, noise_quality::fast};
}

class ensemble_block {
 public:
  /// No noise: the scene without its noise vectors.
  ensemble_block(isa level, report::scene scene, std::string_view scheme, ensemble_noise noise)
      : level_(level), noise_(noise) {
    if (noise == ensemble_noise::none) scene.vectors("sigma").clear();
    choose_isa(level);
    bound_ = bind_scene(scene);
    const auto entry = std::ranges::find(bound_.schemes, scheme, [](const auto& e) { return e.info.name; });
    if (entry == bound_.schemes.end()) throw std::invalid_argument("no scheme " + std::string(scheme));
    kernel_ = entry->make(dt);
    own_.emplace(*bound_.model, chunk, entry->needs_areas, fastest_noise());
    if (noise == ensemble_noise::common)
      common_ = kernel_->share(shared_increments(*bound_.model, seed, steps, dt, entry->needs_areas, 1).view(0, steps));
  }

  /// Sets every path to the scene's momentum and advances it by `steps`; the increments of own noise are drawn here.
  const std::vector<double>& advance() {
    choose_isa(level_);
    states_ = replicated(bound_.scene.momentum);
    if (noise_ == ensemble_noise::common) kernel_->advance(states_, common_, 0, steps);
    if (noise_ == ensemble_noise::none) kernel_->advance(states_, silence(steps));
    if (noise_ == ensemble_noise::independent)
      for (int done = 0; done < steps; done += chunk, step_ += chunk)
        kernel_->advance(states_, own_->fill(seed, 0, step_, chunk, dt), {done == 0, done + chunk == steps});
    return states_;
  }

 private:
  isa level_;
  ensemble_noise noise_;
  subject bound_;
  std::unique_ptr<kernel> kernel_;
  std::optional<increment_buffer> own_;
  shared_steps common_;
  std::vector<double> states_;
  std::uint64_t step_ = 0;
};

inline loop scheme_loop(isa level, const report::scene& scene, std::string_view scheme, ensemble_noise noise) {
  const auto block = std::make_shared<ensemble_block>(level, scene, scheme, noise);
  return {static_cast<double>(steps) * block_lanes, [block] { block->advance(); }};
}

/// Precise increments of W for a block of paths, [step][channel][path].
inline std::vector<double> block_of_increments(const report::scene& scene) {
  const auto bound = bind_scene(scene);
  increment_buffer buffer(*bound.model, steps, false, {noise_generator::philox, noise_quality::precise});
  const auto dw = buffer.fill(seed, 0, 0, steps, dt).dw;
  return {dw.begin(), dw.end()};
}

/// Normals alone, three for every path and step.
inline loop own_normals_loop(isa level, const report::scene& scene) {
  choose_isa(level);
  const auto bound = std::make_shared<subject>(bind_scene(scene));
  const auto buffer = std::make_shared<increment_buffer>(*bound->model, chunk, false, fastest_noise());
  const auto draw = [=, step = std::uint64_t{0}]() mutable {
    choose_isa(level);
    buffer->fill(seed, 0, step += chunk, chunk, dt);
  };
  return {3.0 * chunk * block_lanes, draw, "normal"};
}

/// A whole ensemble on some threads, as `polhode simulate` runs it.
inline loop threads_loop(int threads, const report::scene& scene, std::string_view scheme, ensemble_noise noise) {
  choose_isa(usable_isas().back());
  const auto bound = std::make_shared<subject>(bind_scene(scene));
  const auto entry = std::ranges::find(bound->schemes, scheme, [](const auto& e) { return e.info.name; });
  const std::shared_ptr<kernel> made = entry->make(dt);
  simulation_plan plan;
  plan.noise = noise;
  plan.momentum = scene.momentum;
  plan.steps = 1024;
  plan.bodies = 4096;
  plan.with_areas = entry->needs_areas;
  plan.seed = seed;
  plan.threads = threads;
  plan.source = fastest_noise();
  const double items = static_cast<double>(plan.steps * plan.bodies);
  return {items, [=] { simulate_ensemble(*bound->model, *made, plan); }};
}

}  // namespace polhode::bench
