// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/simulation_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <future>
#include <optional>

#include "reports/writers/density_picture.hpp"
#include "reports/writers/disk.hpp"
#include "reports/writers/npy.hpp"
#include "reports/writers/numbers.hpp"
#include "reports/writers/png.hpp"
#include "reports/writers/simulation_json.hpp"
#include "reports/writers/whole_folder.hpp"

namespace polhode::report {
namespace {

constexpr std::int64_t most_rows = 100'000;  // beyond that text is a burden
using jobs = std::vector<std::function<void()>>;

/// Each once, in any order; returns when all have ended, and throws what one of them threw.
void do_all(const jobs& all, int threads) {
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (auto i = next++; i < all.size(); i = next++) all[i]();
  };
  std::vector<std::future<void>> others;
  for (std::size_t t = 1; t < std::min(static_cast<std::size_t>(std::max(threads, 1)), all.size()); ++t)
    others.push_back(std::async(std::launch::async, work));
  work();
  for (auto& other : others) other.get();
}

std::string final_csv(const simulation& s) {
  const auto dimension = s.final.components.size(), bodies = static_cast<std::size_t>(s.bodies);
  std::string out;
  for (std::size_t k = 0; k < dimension; ++k) out += (k == 0 ? "" : ",") + s.component(k);
  for (std::size_t i = 0; i < bodies; ++i)
    for (std::size_t k = 0; k < dimension; ++k) out += (k == 0 ? "\n" : ",") + shortest(s.states[k * bodies + i]);
  return out + '\n';
}

std::string snapshot_name(const ensemble_snapshot& shown, std::string_view ending) {
  return fmt::format("snapshot_{:.10g}.{}", shown.state.time, ending);
}

std::string counts_npy(const ensemble_snapshot& shown) {
  return to_npy(shown.counts, {static_cast<std::size_t>(shown.heights), static_cast<std::size_t>(shown.longitudes)});
}

/// A row of equal z a line, as the array has it.
std::string counts_csv(const ensemble_snapshot& shown) {
  std::string out;
  const auto width = static_cast<std::size_t>(shown.longitudes);
  for (std::size_t i = 0; i < shown.counts.size(); ++i) {
    out += fmt::format_int(shown.counts[i]).c_str();
    out += (i + 1) % width == 0 ? '\n' : ',';
  }
  return out;
}

namespace fs = std::filesystem;

bool is_our_file(std::string_view name) {
  const bool snapshot =
      name.starts_with("snapshot_") && (name.ends_with(".npy") || name.ends_with(".csv") || name.ends_with(".png"));
  return snapshot || name == "final.csv" || name == "final.npy" || name == "summary.json" || name == recorded_npy ||
         name == recorded_csv;
}

const folder_contents simulation_contents{"simulation", is_our_file, "summary.json", looks_like_simulation};

}  // namespace

std::string final_name(const simulation& s) { return s.bodies > most_rows ? "final.npy" : "final.csv"; }

void write_simulation_files(const std::filesystem::path& folder, const simulation& s, const snapshot_style& style,
                            const std::filesystem::path& known_as) {
  const auto write = [&](const std::string& name, const std::string& content) {
    disk::write_file(folder / name, content, known_as / name);
  };
  std::optional<density_picture> picture;
  jobs first, pictures;
  if (!s.snapshots.empty())
    first.emplace_back([&] { picture.emplace(s.snapshots.front().side, colour_maps()[style.colour_map]); });
  if (!s.states.empty())
    first.emplace_back([&] {
      write(final_name(s), s.bodies > most_rows ? to_npy_rows(s.states, s.final.components.size()) : final_csv(s));
    });
  first.emplace_back([&] { write("summary.json", to_json(s)); });
  for (const auto& shown : s.snapshots) {
    first.emplace_back([&] {
      write(snapshot_name(shown, style.as_text ? "csv" : "npy"), style.as_text ? counts_csv(shown) : counts_npy(shown));
    });
    pictures.emplace_back([&] { write(snapshot_name(shown, "png"), to_png(picture->paint(s, shown))); });
  }
  do_all(first, s.provenance.threads);
  do_all(pictures, s.provenance.threads);
}

void check_simulation_folder(const fs::path& out) { check_whole_folder(out, simulation_contents); }

void write_simulation(const fs::path& out, const simulation& s, const snapshot_style& style) {
  write_whole_folder(out, simulation_contents,
                     [&](const fs::path& folder) { write_simulation_files(folder, s, style, out); });
}

simulation write_simulation(const fs::path& out, const run_into_folder& run, const snapshot_style& style) {
  simulation result;
  write_whole_folder(out, simulation_contents, [&](const fs::path& folder) {
    result = run(folder);
    write_simulation_files(folder, result, style, out);
  });
  return result;
}

}  // namespace polhode::report
