// A scene: the problem on which schemes are tried. Read from TOML (CONTRACT: "A scene") or built in.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

struct scene {
  std::string name;
  std::string system = "rigid_body";
  std::array<double, 3> inertia{};
  double theta = 0;                          ///< dissipation, >= 0
  std::vector<std::array<double, 3>> sigma;  ///< the noise vectors sigma_i as given; empty or all zero: no noise
  std::vector<double> momentum;              ///< initial momentum Pi_0
  double horizon = 0;                        ///< end time T > 0
  std::vector<std::int64_t> steps;           ///< numbers of steps to the horizon, strictly increasing
};

/// The scene of that built-in name, or the file of that path. Throws input_error.
scene load_scene(std::string_view name_or_path);

/// Names of the built-in scenes, in the order in which they are listed.
std::vector<std::string> builtin_scenes();

}  // namespace polhode
