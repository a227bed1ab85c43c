// SPDX-License-Identifier: Apache-2.0
// The text of a scene: what a command does with the file that it is given, before it computes.
#include "fuzz.hpp"
#include "reports/writers/json.hpp"
#include "scene/scene_parse.hpp"
#include "systems/systems.hpp"

namespace {

bool same(const polhode::scene& a, const polhode::scene& b) {
  return a.name == b.name && a.system == b.system && a.parameters == b.parameters && a.momentum == b.momentum &&
         a.horizon == b.horizon && a.steps == b.steps;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace polhode;
  const auto scene = fuzz::taken([&] { return parse_scene(fuzz::text_of(data, size), "scene.toml", "scene"); });
  if (!scene) return 0;
  report::results kept;
  kept.scene = *scene;
  fuzz::demand(same(report::from_json(report::to_json(kept)).scene, *scene), "a scene reads back as the same");
  find_system(scene->system)->offers(*scene);
  return 0;
}
