// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>
#include <vector>

#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"
#include "reports/writers/csv.hpp"
#include "reports/writers/digest.hpp"
#include "reports/writers/disk.hpp"
#include "reports/writers/html.hpp"
#include "reports/writers/json.hpp"
#include "reports/writers/junit.hpp"
#include "reports/writers/latex.hpp"
#include "reports/writers/markdown.hpp"
#include "reports/writers/output_folder.hpp"

namespace polhode::report {
namespace {

namespace fs = std::filesystem;

struct written_file {
  const char* name;
  std::string (*text)(const results&);
  bool always = true;
};
constexpr written_file files[] = {
    {"results.json", to_json},      {"digest.json", to_digest},     {"measurements.csv", measurements_csv},
    {"verdicts.csv", verdicts_csv}, {"report.html", to_html},       {"report.md", to_markdown},
    {"junit.xml", to_junit},        {"report.tex", to_latex, false}};

bool is_written_file(const fs::path& path) {
  return std::any_of(std::begin(files), std::end(files),
                     [&](const auto& file) { return path.filename() == file.name; });
}

// Files of ours alone, and a results.json that begins as ours does: anything else might be somebody's work.
bool is_report(const fs::directory_entry& entry, const fs::path& known_as) {
  std::error_code error;
  if (!fs::is_directory(entry.symlink_status(error))) return false;
  for (fs::directory_iterator file(entry.path(), error), end; !error && file != end; file.increment(error))
    if (!is_written_file(file->path())) return false;
  if (error) disk::fail(known_as, error.value());
  return looks_like_results(beginning_of(entry.path() / "results.json", known_as / "results.json"));
}

void require_report_files(const fs::path& folder, const fs::path& known_as) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const auto name = entry->path().filename();
    if (disk::is_staging_name(name.string()) || is_report(*entry, known_as / name)) continue;
    throw input_error(
        fmt::format("output folder {}: {} in it is not a polhode report; give a new or empty folder, or one that holds "
                    "polhode reports only",
                    quoted(known_as), quoted(name)));
  }
  if (error) disk::fail(known_as, error.value());
}

// Throws unless reports can be put there; `path` is the settled form of `out`.
void require_usable(const fs::path& path, const fs::path& out) {
  const auto nearest = nearest_folder(path, out);
  if (nearest == path) require_report_files(path, out);
  require_writable(nearest, nearest == path ? out : nearest);
}

void write_files(const fs::path& folder, const results& r, latex with, const fs::path& known_as) {
  for (const auto& file : files)
    if (file.always || with == latex::yes) disk::write_file(folder / file.name, file.text(r), known_as / file.name);
  disk::sync_directory(folder, known_as);
}

// Every scene is staged before the first one is exchanged: a full disk leaves the old reports untouched.
void write_into(const fs::path& path, std::span<const results> all, latex with, const fs::path& out) {
  disk::remove_stale(path);
  std::vector<std::unique_ptr<disk::staging>> staged;
  for (const auto& r : all) {
    const auto name = folder_name(r.scene.name);
    staged.push_back(std::make_unique<disk::staging>(path / disk::staging_name(name), out / name));
    write_files(staged.back()->path(), r, with, out / name);
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    disk::put_in_place(staged[i]->path(), path / folder_name(all[i].scene.name));
  disk::sync_directory(path, out);
}

void write_new(const fs::path& path, std::span<const results> all, latex with, const fs::path& out) {
  const fs::path parent = path.parent_path();
  made_parents parents(parent);
  const auto name = path.filename().string();
  disk::remove_stale(parent, name);
  const disk::staging staged(parent / disk::staging_name(name), out);
  for (const auto& r : all) {
    const auto folder = folder_name(r.scene.name);
    disk::make_directory(staged.path() / folder, out / folder);
    write_files(staged.path() / folder, r, with, out / folder);
  }
  disk::sync_directory(staged.path(), out);
  if (!disk::move_if_free(staged.path(), path, out)) {  // somebody made it meanwhile
    require_usable(path, out);
    for (const auto& r : all)
      disk::put_in_place(staged.path() / folder_name(r.scene.name), path / folder_name(r.scene.name));
  }
  parents.keep();
  disk::sync_directory(parent, out);
}

}  // namespace

void check_output_folder(const fs::path& out) { require_usable(settled(out), out); }

void write_report(const fs::path& out, std::span<const results> all, latex with) {
  std::set<std::string> names;
  for (const auto& r : all)
    if (!names.insert(folder_name(r.scene.name)).second)
      throw input_error(fmt::format("scene '{}': there are two of that name; a report needs one folder a scene",
                                    one_line(r.scene.name)));
  if (all.empty()) return;
  const fs::path path = settled(out);
  require_usable(path, out);
  if (stands(path)) return write_into(path, all, with, out);
  write_new(path, all, with, out);
}

}  // namespace polhode::report
