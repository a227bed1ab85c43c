// SPDX-License-Identifier: Apache-2.0
// A folder that holds one product, complete or not there: a simulation, a page of reproductions.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace polhode::report {

/// What such a folder may hold; anything else might be somebody's work.
struct folder_contents {
  std::string what;                                   ///< "simulation", in refusals
  std::function<bool(std::string_view)> is_ours;      ///< a file by its name
  std::string document;                               ///< the JSON file that every such folder has
  std::function<bool(std::string_view)> begins_ours;  ///< its first 256 bytes
};

/// Refuses what cannot be written there: input_error where the folder holds anything else, output_error where the disk
/// refuses. Creates nothing.
void check_whole_folder(const std::filesystem::path& out, const folder_contents&);

/// `write` fills a folder beside it, which is then exchanged in one step. Either error leaves no trace.
void write_whole_folder(const std::filesystem::path& out, const folder_contents&,
                        const std::function<void(const std::filesystem::path& folder)>& write);

}  // namespace polhode::report
