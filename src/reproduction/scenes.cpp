// SPDX-License-Identifier: Apache-2.0
#include "reproduction/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "scene/scene_parse.hpp"
#include "statistics/orders/log_line.hpp"

namespace polhode {

scene scene_of(std::string_view text) { return parse_scene(text, "reproduce", "reproduce"); }

const scheme_entry& scheme_of(const subject& s, std::string_view name) {
  const auto found = std::ranges::find(s.schemes, name, [](const scheme_entry& e) { return e.info.name; });
  if (found == s.schemes.end()) throw std::logic_error("no scheme " + std::string(name) + " on " + s.scene.name);
  return *found;
}

double slope_of_means(std::span<const double> means, std::span<const double> dt) {
  std::vector<log_level> levels;
  for (std::size_t l = 0; l < means.size(); ++l)
    levels.push_back({static_cast<int>(l), std::log2(dt[l]), std::log2(means[l]), 0});
  return line_through(levels).slope;
}

}  // namespace polhode
