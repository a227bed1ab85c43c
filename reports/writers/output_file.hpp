// SPDX-License-Identifier: Apache-2.0
// What every command that writes one file asks of its place first. Each refusal names the file as the user gave it.
#pragma once

#include <filesystem>

namespace polhode::report {

/// The file that is really meant: absolute, links followed. Throws input_error for an empty name and for what stands
/// there and is no file, output_error where its folder is missing or may not be written to.
std::filesystem::path settled_file(const std::filesystem::path& out);

}  // namespace polhode::report
