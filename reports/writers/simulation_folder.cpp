#include "reports/writers/simulation_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <string_view>
#include <vector>

#include "reports/model/errors.hpp"
#include "reports/writers/disk.hpp"
#include "reports/writers/simulation_files.hpp"
#include "reports/writers/simulation_json.hpp"
#include "reports/writers/text.hpp"

namespace polhode::report {
namespace {

namespace fs = std::filesystem;

std::string quoted(const fs::path& path) { return "'" + one_line(path.string()) + "'"; }

bool is_our_file(std::string_view name) {
  const bool snapshot = name.starts_with("snapshot_") && (name.ends_with(".npy") || name.ends_with(".png"));
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

bool stands(const fs::path& path) {
  std::error_code error;
  const auto status = fs::status(path, error);
  if (error && status.type() != fs::file_type::not_found) disk::fail(path, error.value());
  return fs::exists(status);
}

/// The path that is really meant, once nothing speaks against writing there.
fs::path usable(const fs::path& out) {
  if (out.empty()) throw input_error("output folder: the name is empty; give the name of a folder");
  std::error_code error;
  if (fs::is_symlink(out, error) && !fs::exists(out, error))
    throw input_error(fmt::format("output folder {}: is a link to nowhere; give a folder or a new name", quoted(out)));
  fs::path path = fs::weakly_canonical(fs::absolute(out), error);
  if (error) disk::fail(out, error.value());
  if (!path.has_filename()) path = path.parent_path();
  fs::path nearest = path;
  while (!stands(nearest)) nearest = nearest.parent_path();
  if (!fs::is_directory(nearest))
    throw input_error(
        fmt::format("output folder {}: {} is not a folder; give a folder or a new name", quoted(out), quoted(nearest)));
  if (nearest == path) require_ours(path, out);
  // A folder is exchanged through its neighbour, so its parent must be open to us.
  const auto parent = nearest == path ? path.parent_path() : nearest;
  if (::faccessat(AT_FDCWD, parent.c_str(), W_OK | X_OK, AT_EACCESS) != 0) disk::fail(parent, errno);
  return path;
}

/// Folders that were missing above the output; gone again unless kept.
class made_parents {
 public:
  explicit made_parents(const fs::path& folder) {
    std::vector<fs::path> missing;
    for (fs::path one = folder; !stands(one); one = one.parent_path()) missing.push_back(one);
    for (; !missing.empty(); missing.pop_back()) {
      disk::make_directory(missing.back(), missing.back());
      made_.push_back(missing.back());
    }
  }
  ~made_parents() {
    for (; !made_.empty(); made_.pop_back()) ::rmdir(made_.back().c_str());
  }
  made_parents(const made_parents&) = delete;
  made_parents& operator=(const made_parents&) = delete;
  void keep() { made_.clear(); }

 private:
  std::vector<fs::path> made_;
};

}  // namespace

void check_simulation_folder(const fs::path& out) { usable(out); }

void write_simulation(const fs::path& out, const simulation& s) {
  const auto path = usable(out);
  const auto parent = path.parent_path();
  made_parents parents(parent);
  const auto name = path.filename().string();
  disk::remove_stale(parent, name);
  const disk::staging staged(parent / disk::staging_name(name), out);
  write_simulation_files(staged.path(), s, out);
  disk::sync_directory(staged.path(), out);
  if (!disk::move_if_free(staged.path(), path, out)) {
    usable(out);  // somebody may have put something there meanwhile
    disk::put_in_place(staged.path(), path);
  }
  parents.keep();
  disk::sync_directory(parent, out);
}

}  // namespace polhode::report
