// SPDX-License-Identifier: Apache-2.0
// What every command that writes a folder, or one file, asks of its place first. Each refusal names the place as the
// user gave it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace polhode::report {

/// In quotes, on one line.
std::string quoted(const std::filesystem::path&);

/// Whether anything is there; throws output_error where the system will not say.
bool stands(const std::filesystem::path&);

/// The path that is really meant: absolute, links followed, no trailing slash. Throws input_error for an empty name and
/// for a link to nowhere.
std::filesystem::path settled(const std::filesystem::path& out);

/// `path`, or the nearest above it that stands; throws input_error where that is no folder.
std::filesystem::path nearest_folder(const std::filesystem::path& path, const std::filesystem::path& out);

/// Its first 256 bytes, nothing where it does not stand; throws output_error where the system does not let us look.
std::string beginning_of(const std::filesystem::path& file, const std::filesystem::path& known_as);

void require_writable(const std::filesystem::path& folder, const std::filesystem::path& known_as);

/// Makes the folders that are missing down to `folder`; they are gone again unless kept.
class made_parents {
 public:
  explicit made_parents(const std::filesystem::path& folder);
  ~made_parents();
  made_parents(const made_parents&) = delete;
  made_parents& operator=(const made_parents&) = delete;
  void keep() { made_.clear(); }

 private:
  std::vector<std::filesystem::path> made_;
};

/// The file that is really meant: absolute, links followed. Throws input_error for an empty name and for what stands
/// there and is no file, output_error where its folder is missing or may not be written to.
std::filesystem::path settled_file(const std::filesystem::path& out);

}  // namespace polhode::report
