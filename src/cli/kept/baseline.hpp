// SPDX-License-Identifier: Apache-2.0
// Named results of an earlier run, to which a run is held, and which it may become.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reports/model/comparison.hpp"
#include "reports/model/results.hpp"

namespace polhode::cli {

class baseline {
 public:
  /// Throws input_error, before any work, where there is nothing of that name, where a
  /// scene is not in it or was another one, and where nothing can be saved.
  baseline(const std::optional<std::string>& name, const std::optional<std::string>& save_as,
           std::span<const report::scene>);

  /// In the order of the scenes; nothing where no baseline is named.
  std::vector<report::comparison> compare(std::span<const report::results>) const;
  /// Replaces what has these scenes and this name.
  void save(std::span<const report::results>) const;

 private:
  std::vector<report::results> before_;
  std::filesystem::path save_to_;
};

}  // namespace polhode::cli
