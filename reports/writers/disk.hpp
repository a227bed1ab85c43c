// SPDX-License-Identifier: Apache-2.0
// The few file operations that must not fail in silence. Each throws output_error, naming the path that the user knows
// (`known_as`: staging directories are nobody's business) and what the system said.
#pragma once

#include <filesystem>
#include <string_view>

namespace polhode::report::disk {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& known_as, int error);

/// Creates the file, writes, flushes to the disk, closes; every step is checked.
void write_file(const fs::path&, std::string_view content, const fs::path& known_as);

void make_directory(const fs::path&, const fs::path& known_as);

/// Makes the names inside it durable.
void sync_directory(const fs::path&, const fs::path& known_as);

/// `from` becomes `to` in one step. What stood at `to` stands at `from` afterwards.
void put_in_place(const fs::path& from, const fs::path& to);

/// The whole content or none: written beside it, then put in its place, whatever file stood there.
void replace_file(const fs::path&, std::string_view content, const fs::path& known_as);

/// False where something stands at `to` already; nothing has changed then.
bool move_if_free(const fs::path& from, const fs::path& to, const fs::path& known_as);

/// A hidden directory, ours alone, held by a lock as long as this lives; removed at the end unless it was moved away.
class staging {
 public:
  staging(fs::path where, const fs::path& known_as);
  ~staging();
  staging(const staging&) = delete;
  staging& operator=(const staging&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
  int lock_ = -1;
};

/// Removes the directory that was staged last with all that it holds: for the handler of a signal that ends the program
/// while its other threads go on.
void remove_last_staged() noexcept;

/// ".<name>.partial-<pid>" of this process.
fs::path staging_name(std::string_view name);
/// Whether that is such a name, of any process.
bool is_staging_name(std::string_view);
/// Removes the staging directories in `folder` whose makers are dead; those of that name only, if one is given.
void remove_stale(const fs::path& folder, std::string_view name = {});

}  // namespace polhode::report::disk
