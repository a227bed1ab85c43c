// SPDX-License-Identifier: Apache-2.0
// What is measured, and under which names.
#pragma once

#include <fmt/core.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "ensemble/simulation.hpp"
#include "platform/isa.hpp"
#include "reports/model/results.hpp"

namespace polhode::bench {

inline constexpr std::array all_noises{ensemble_noise::none, ensemble_noise::common, ensemble_noise::independent};
constexpr std::string_view name_of(ensemble_noise noise) {
  return noise == ensemble_noise::none ? "none" : noise == ensemble_noise::common ? "common" : "independent";
}

/// The scene `paper`, or that scene with one part changed.
struct scene_feature {
  std::string name;
  report::scene scene;
};
std::vector<scene_feature> scene_features();

/// Every scheme that steps the scene's system; and those that are measured on every feature and held beside the
/// yardsticks.
std::vector<std::string> scheme_names(const report::scene&);
inline constexpr std::array<std::string_view, 3> main_schemes{"heun", "strang", "lie_heun"};

/// A scene of each other system.
inline constexpr std::array<std::string_view, 10> scenes_of_systems{
    "spin",      "random_inertia", "maxwell_bloch", "so4",     "heavy_top",
    "spin_pair", "spin_ring",      "vortices",      "manakov", "sine_euler"};

inline std::string scheme_key(std::string_view scheme, ensemble_noise noise, std::string_view feature, isa level) {
  return fmt::format("scheme/{}/{}/{}/{}", scheme, name_of(noise), feature, name_of(level));
}
inline std::string eigen_key(std::string_view scheme, ensemble_noise noise) {
  return fmt::format("eigen_std/{}/{}", scheme, name_of(noise));
}
inline std::string headers_key(std::string_view scheme) { return fmt::format("headers/{}", scheme); }
inline std::string scalar_key(std::string_view scheme) { return fmt::format("scalar_kernel/{}", scheme); }
inline std::string soa_key(ensemble_noise noise) { return fmt::format("soa_ziggurat/heun/{}", name_of(noise)); }
inline std::string by_hand_key(isa level) { return fmt::format("by_hand/heun/none/{}", name_of(level)); }
inline std::string peak_key(isa level) { return fmt::format("peak/{}", name_of(level)); }
inline std::string normals_key(isa level) { return fmt::format("normals/own/{}", name_of(level)); }
inline std::string threads_key(std::string_view scheme, ensemble_noise noise, int threads) {
  return fmt::format("threads/{}/{}/{}", scheme, name_of(noise), threads);
}
inline constexpr const char* odeint_key = "odeint_rk4/none";

/// Registers all of it.
void register_everything();

}  // namespace polhode::bench
