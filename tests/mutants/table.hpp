// SPDX-License-Identifier: Apache-2.0
// The table of planted defects: all of them as data.
#pragma once

#include <string_view>
#include <vector>

#include "mutants/defect.hpp"

namespace polhode::test {

struct row {
  defect planted;
  std::string_view scheme, scene;
  bool asked = true;                 ///< to be refuted; else the size is there to find where refutation ends
  std::string_view experiment = {};  ///< the one that must refute it; empty: any
};

/// Built-in scenes, and those of the table's own: "weak noise", "hard".
report::scene scene_named(std::string_view);

/// All rows; each block of the source is a kind at several sizes, on several schemes and scenes.
std::vector<row> table();

/// Those of the generator, which are in force in the whole process: one at a time.
std::vector<row> generator_table();

/// The few that every push tries: of each kind the smallest size that is cheap to refute, by the experiment named.
std::vector<row> sharpest();

/// What of a verdict's claim must stand there for it to count; empty: any refuted claim is a refutation.
std::string_view claim_of(kind);

}  // namespace polhode::test
