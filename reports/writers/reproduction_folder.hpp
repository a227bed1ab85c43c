// SPDX-License-Identifier: Apache-2.0
// The folder of a page of reproductions.
#pragma once

#include <filesystem>
#include <span>

#include "reports/model/reproduction.hpp"

namespace polhode::report {

/// Writes reproductions.html, reproductions.md and reproductions.json. A folder of ours that stands there is exchanged
/// in one step. Throws input_error where it holds anything else, output_error where the disk refuses; neither leaves a
/// trace.
void write_reproductions(const std::filesystem::path& out, std::span<const reproduction>);

/// The same refusals, before the work starts. Creates nothing.
void check_reproduction_folder(const std::filesystem::path& out);

}  // namespace polhode::report
