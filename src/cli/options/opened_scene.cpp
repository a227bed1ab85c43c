// SPDX-License-Identifier: Apache-2.0
#include "cli/options/opened_scene.hpp"

#include <fmt/format.h>

#include "cli/terminal/terminal.hpp"
#include "systems/systems.hpp"

namespace polhode::cli {

scene opened_scene(const std::string& name_or_path) {
  auto s = load_scene(name_or_path);
  const auto notice = find_system(s.system)->offers(s).notice;
  if (!notice.empty()) print_error(fmt::format("note: scene {}: {}", s.name, notice));
  return s;
}

}  // namespace polhode::cli
