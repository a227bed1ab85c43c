// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/whole_folder.hpp"

#include <fmt/format.h>

#include "reports/model/errors.hpp"
#include "reports/writers/disk.hpp"
#include "reports/writers/output_folder.hpp"

namespace polhode::report {
namespace {

namespace fs = std::filesystem;

/// Empty, or one of ours and nothing besides.
void require_whole_folder(const fs::path& folder, const fs::path& known_as, const folder_contents& c) {
  const auto refuse = [&](const fs::path& file) {
    throw input_error(fmt::format(
        "output folder {}: {} in it is not of a {}; give a new or empty folder, or one that holds a {} only",
        quoted(known_as), quoted(file.filename()), c.what, c.what));
  };
  std::error_code error;
  bool any = false;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (!c.is_ours(entry->path().filename().string()) || !entry->is_regular_file(error)) refuse(entry->path());
    any = true;
  }
  if (error) disk::fail(known_as, error.value());
  if (any && !c.begins_ours(beginning_of(folder / c.document, known_as / c.document))) refuse(c.document);
}

/// The path that is really meant, once nothing speaks against writing there.
fs::path usable(const fs::path& out, const folder_contents& c) {
  const auto path = settled(out);
  const auto nearest = nearest_folder(path, out);
  if (nearest == path) require_whole_folder(path, out, c);
  // A folder is exchanged through its neighbour, so its parent must be open to us.
  const auto parent = nearest == path ? path.parent_path() : nearest;
  require_writable(parent, parent);
  return path;
}

}  // namespace

void check_whole_folder(const fs::path& out, const folder_contents& c) { usable(out, c); }

void write_whole_folder(const fs::path& out, const folder_contents& c,
                        const std::function<void(const fs::path& folder)>& write) {
  const auto path = usable(out, c);
  const auto parent = path.parent_path();
  made_parents parents(parent);
  const auto name = path.filename().string();
  disk::remove_stale(parent, name);
  const disk::staging staged(parent / disk::staging_name(name), out);
  write(staged.path());
  disk::sync_directory(staged.path(), out);
  if (!disk::move_if_free(staged.path(), path, out)) {
    usable(out, c);  // somebody may have put something there meanwhile
    disk::put_in_place(staged.path(), path);
  }
  parents.keep();
  disk::sync_directory(parent, out);
}

}  // namespace polhode::report
