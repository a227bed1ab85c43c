// SPDX-License-Identifier: Apache-2.0
#include "cli/kept/baseline.hpp"

#include <fmt/format.h>

#include "cli/kept/read_results.hpp"
#include "cli/kept/user_folders.hpp"
#include "comparison/compare.hpp"
#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"
#include "reports/writers/folder.hpp"

namespace polhode::cli {

baseline::baseline(const std::optional<std::string>& name, const std::optional<std::string>& save_as,
                   std::span<const report::scene> scenes) {
  if (save_as) {
    save_to_ = baseline_folder("--save-baseline", *save_as);
    report::check_output_folder(save_to_);
  }
  if (!name) return;
  const auto folder = baseline_folder("--baseline", *name);
  for (const auto& scene : scenes) {
    const auto of_scene = folder / report::folder_name(scene.name);
    if (!std::filesystem::exists(of_scene))
      throw input_error(
          fmt::format("--baseline '{}': holds no scene '{}'; accepted: what --save-baseline has kept in {}", *name,
                      one_line(scene.name, 60), one_line(folder.string(), 200)));
    before_.push_back(read_results(of_scene));
    try {
      check_same_scene(before_.back().scene, scene);
    } catch (const input_error& fault) {
      throw input_error(fmt::format("--baseline '{}': {}", *name, fault.what()));
    }
  }
}

std::vector<report::comparison> baseline::compare(std::span<const report::results> after) const {
  std::vector<report::comparison> out;
  for (std::size_t i = 0; i < before_.size(); ++i) out.push_back(polhode::compare(before_[i], after[i]));
  return out;
}

void baseline::save(std::span<const report::results> all) const {
  if (!save_to_.empty()) report::write_report(save_to_, all);
}

}  // namespace polhode::cli
