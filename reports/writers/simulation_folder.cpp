// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/simulation_folder.hpp"

#include "reports/writers/simulation_json.hpp"
#include "reports/writers/whole_folder.hpp"

namespace polhode::report {
namespace {

namespace fs = std::filesystem;

bool is_our_file(std::string_view name) {
  const bool snapshot =
      name.starts_with("snapshot_") && (name.ends_with(".npy") || name.ends_with(".csv") || name.ends_with(".png"));
  return snapshot || name == "final.csv" || name == "final.npy" || name == "summary.json" || name == recorded_npy ||
         name == recorded_csv;
}

const folder_contents contents{"simulation", is_our_file, "summary.json", looks_like_simulation};

}  // namespace

void check_simulation_folder(const fs::path& out) { check_whole_folder(out, contents); }

void write_simulation(const fs::path& out, const simulation& s, const snapshot_style& style) {
  write_whole_folder(out, contents, [&](const fs::path& folder) { write_simulation_files(folder, s, style, out); });
}

simulation write_simulation(const fs::path& out, const run_into_folder& run, const snapshot_style& style) {
  simulation result;
  write_whole_folder(out, contents, [&](const fs::path& folder) {
    result = run(folder);
    write_simulation_files(folder, result, style, out);
  });
  return result;
}

}  // namespace polhode::report
