// SPDX-License-Identifier: Apache-2.0
#include "bench/catalogue.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>

#include "bench/counted_flops.hpp"
#include "bench/ensemble_loop.hpp"
#include "bench/yardsticks.hpp"
#include "scene/scene.hpp"

namespace polhode::bench {
namespace {

const report::scene& paper() {
  static const report::scene scene = load_scene("paper");
  return scene;
}
momentum start() { return {paper().momentum[0], paper().momentum[1], paper().momentum[2]}; }

void add_peaks() {
  for (const isa level : usable_isas()) add(peak_key(level), [level] { return peak_loop(level); });
}

void add_schemes() {
  const auto add_one = [](const std::string& scheme, ensemble_noise noise, const scene_feature& f, isa level) {
    add(scheme_key(scheme, noise, f.name, level), [=] { return scheme_loop(level, f.scene, scheme, noise); });
  };
  const auto features = scene_features();
  for (const auto& scheme : scheme_names(paper()))
    for (const auto noise : all_noises)
      for (const isa level : usable_isas()) add_one(scheme, noise, features.front(), level);
  for (const auto scheme : main_schemes)
    for (const auto noise : all_noises)
      for (std::size_t i = 1; i < features.size(); ++i)
        add_one(std::string(scheme), noise, features[i], usable_isas().back());
}

/// Every scheme under every noise on the widest instruction set; on the others the main schemes under a common noise.
void add_other_systems() {
  for (const auto name : scenes_of_systems) {
    const auto scene = load_scene(std::string(name));
    for (const auto& scheme : scheme_names(scene))
      for (const auto noise : all_noises)
        for (const isa level : usable_isas())
          if (level == usable_isas().back() ||
              (noise == ensemble_noise::common && std::ranges::count(main_schemes, scheme) > 0))
            add(scheme_key(scheme, noise, name, level), [=] { return scheme_loop(level, scene, scheme, noise); });
  }
}

template <class F>
loop kept(double items, F f, const char* unit = "path_step") {
  return {items, [f] { benchmark::DoNotOptimize(f()); }, unit};
}

void add_yardsticks() {
  static const shared_increments common(*bind_scene(paper()).model, seed, steps, dt, false, 1);
  const auto w = common.view(0, steps).dw;
  for (std::size_t i = 0; i < main_schemes.size(); ++i)
    for (const auto noise : all_noises)
      add(eigen_key(main_schemes[i], noise), [=] {
        return kept(steps, [=] { return eigen_std(static_cast<yard_scheme>(i), noise, start(), w, steps, dt); });
      });
  for (const auto noise : all_noises)
    add(soa_key(noise),
        [=] { return kept(steps * soa_paths, [=] { return soa_ziggurat_heun(noise, start(), w, steps, dt); }); });
  add(odeint_key, [] { return kept(steps, [] { return odeint_rk4(start(), steps, dt); }); });
  for (const isa level : usable_isas())
    add(by_hand_key(level), [level] { return by_hand_loop(level, paper(), steps, dt); });
}

/// In turns, so that what a busy machine does to one it does to the other.
void add_headers() {
  static const std::vector<double> dw = block_of_increments(paper());
  for (std::size_t i = 0; i < main_schemes.size(); ++i) {
    const auto scheme = static_cast<yard_scheme>(i);
    add(headers_key(main_schemes[i]),
        [=] { return kept(steps * block_lanes, [=] { return by_headers(scheme, start(), dw, steps, dt); }); });
    add(scalar_key(main_schemes[i]),
        [=] { return kept(steps * block_lanes, [=] { return by_scalar_kernel(scheme, start(), dw, steps, dt); }); });
  }
}

void add_normals() {
  constexpr int count = 4096;
  for (const isa level : usable_isas()) add(normals_key(level), [level] { return own_normals_loop(level, paper()); });
  const std::pair<const char*, double (*)(int)> others[] = {{"normals/std", sum_of_std_normals},
                                                            {"normals/boost_ziggurat", sum_of_boost_normals},
                                                            {"normals/gsl_ziggurat", sum_of_gsl_normals}};
  for (const auto& [name, sum] : others)
    add(name, [sum = sum] {
      return kept(
          count, [sum] { return sum(count); }, "normal");
    });
}

void add_threads() {
  for (const auto scheme : main_schemes)
    for (const auto noise : {ensemble_noise::common, ensemble_noise::independent})
      for (const int threads : {1, 2})
        add(
            threads_key(scheme, noise, threads), [=] { return threads_loop(threads, paper(), scheme, noise); }, true);
}

}  // namespace

std::vector<scene_feature> scene_features() {
  std::vector<scene_feature> features(5, {"paper", paper()});
  features[1].name = "theta_zero";
  features[1].scene.number("theta") = 0;
  features[2].name = "two_equal";
  features[2].scene.vector("inertia") = {1, 1, 3};
  features[3].name = "three_equal";
  features[3].scene.vector("inertia") = {1, 1, 1};
  features[4].name = "general_sigma";
  features[4].scene.vectors("sigma") = {{0.5, 0.1, 0}, {0, 0.4, 0.2}, {0.1, 0, 0.3}};
  return features;
}

std::vector<std::string> scheme_names(const report::scene& scene) {
  std::vector<std::string> names;
  for (const auto& scheme : bind_scene(scene).schemes) names.emplace_back(scheme.info.name);
  return names;
}

void register_everything() {
  add_peaks();
  add_schemes();
  add_other_systems();
  add_yardsticks();
  add_headers();
  add_normals();
  add_threads();
}

}  // namespace polhode::bench
