#include "reports/writers/simulation_folder.hpp"

#include <fmt/format.h>

#include <fstream>
#include <string_view>
#include <vector>

#include "reports/model/errors.hpp"
#include "reports/writers/disk.hpp"
#include "reports/writers/output_folder.hpp"
#include "reports/writers/simulation_files.hpp"
#include "reports/writers/simulation_json.hpp"

namespace polhode::report {
namespace {

namespace fs = std::filesystem;

bool is_our_file(std::string_view name) {
  const bool snapshot =
      name.starts_with("snapshot_") && (name.ends_with(".npy") || name.ends_with(".csv") || name.ends_with(".png"));
  return snapshot || name == "final.csv" || name == "final.npy" || name == "summary.json";
}

bool begins_as_ours(const fs::path& summary) {
  char beginning[256];
  std::ifstream json(summary, std::ios::binary);
  json.read(beginning, sizeof beginning);
  return looks_like_simulation({beginning, static_cast<std::size_t>(json.gcount())});
}

/// Empty, or a simulation of ours and nothing besides: anything else might be somebody's work.
void require_ours(const fs::path& folder, const fs::path& known_as) {
  const auto refuse = [&](const fs::path& file) {
    throw input_error(
        fmt::format("output folder {}: {} in it is not of a simulation; give a new or empty folder, or "
                    "one that holds a simulation only",
                    quoted(known_as), quoted(file.filename())));
  };
  std::error_code error;
  bool any = false;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (!is_our_file(entry->path().filename().string()) || !entry->is_regular_file(error)) refuse(entry->path());
    any = true;
  }
  if (error) disk::fail(known_as, error.value());
  if (any && !begins_as_ours(folder / "summary.json")) refuse("summary.json");
}

/// The path that is really meant, once nothing speaks against writing there.
fs::path usable(const fs::path& out) {
  const auto path = settled(out);
  const auto nearest = nearest_folder(path, out);
  if (nearest == path) require_ours(path, out);
  // A folder is exchanged through its neighbour, so its parent must be open to us.
  const auto parent = nearest == path ? path.parent_path() : nearest;
  require_writable(parent, parent);
  return path;
}

}  // namespace

void check_simulation_folder(const fs::path& out) { usable(out); }

void write_simulation(const fs::path& out, const simulation& s, const snapshot_style& style) {
  const auto path = usable(out);
  const auto parent = path.parent_path();
  made_parents parents(parent);
  const auto name = path.filename().string();
  disk::remove_stale(parent, name);
  const disk::staging staged(parent / disk::staging_name(name), out);
  write_simulation_files(staged.path(), s, style, out);
  disk::sync_directory(staged.path(), out);
  if (!disk::move_if_free(staged.path(), path, out)) {
    usable(out);  // somebody may have put something there meanwhile
    disk::put_in_place(staged.path(), path);
  }
  parents.keep();
  disk::sync_directory(parent, out);
}

}  // namespace polhode::report
