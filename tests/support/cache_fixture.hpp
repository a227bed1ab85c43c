// SPDX-License-Identifier: Apache-2.0
// A cache of the test's own, and what its tests ask of a run.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "reports/writers/csv.hpp"
#include "reports/writers/json.hpp"
#include "reports/writers/result_folder.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "support/own_path.hpp"

namespace polhode::test {

namespace fs = std::filesystem;
using report::result_folder;

struct cache_of_a_test : testing::Test {
  cache_of_a_test() : folder(own_path("cache")) {
    fs::remove_all(folder);
    options.experiments = {"energy", "strong"};      // without noise and with it
    options.schemes = {"heun", "magnus", "strang"};  // drifting, exact with areas, exact without
    options.effort = effort::quick;
    options.threads = 2;
    scene.horizon = 0.125;  // what is found does not matter here, and sanitizers are slow
    scene.steps = {8, 16};
  }
  ~cache_of_a_test() override { fs::remove_all(folder); }

  report::results run(result_folder::access how = result_folder::access::use) {
    result_folder store(folder, how);
    options.store = &store;
    auto r = verify(scene, options);
    options.store = nullptr;
    EXPECT_EQ(store.trouble(), "");
    return r;
  }

  /// {experiments run, results computed, results reused}; the list of what was reused agrees.
  std::vector<std::uint64_t> counted(result_folder::access how = result_folder::access::use) {
    const auto r = run(how);
    EXPECT_EQ(r.done.results_reused, r.reused.size());
    return {r.done.experiments_run, r.done.results_computed, r.done.results_reused};
  }

  std::vector<fs::path> files() const {
    std::vector<fs::path> out;
    for (const auto& entry : fs::directory_iterator(folder)) out.push_back(entry.path());
    std::ranges::sort(out);
    return out;
  }

  fs::path folder;
  polhode::scene scene = load_scene("paper");
  verify_options options;
};
using counts = std::vector<std::uint64_t>;

/// Everything that a run says, without what it says of itself.
inline std::string said(report::results r) {
  r.provenance = {};
  r.savings = {};
  r.reused = {};
  r.done = {};
  return report::to_json(r) + report::measurements_csv(r) + report::verdicts_csv(r);
}

}  // namespace polhode::test
