// SPDX-License-Identifier: Apache-2.0
// The report folder: complete or not there, whenever the process dies and however full the disk is.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "reports/model/results.hpp"

namespace polhode::report {

enum class latex { no, yes };

/// Writes out/<scene>/{results.json, digest.json, measurements.csv, verdicts.csv, report.html, report.md, junit.xml} for each
/// result, and report.tex where LaTeX is asked for. A new `out` appears in one step with all its scenes; in an old one
/// each scene is exchanged in one step. Throws input_error where `out` holds anything but reports, output_error where
/// the disk refuses; neither leaves a trace.
void write_report(const std::filesystem::path& out, std::span<const results>, latex = latex::no);

/// The same refusals, before the work starts. Creates nothing.
void check_output_folder(const std::filesystem::path& out);

/// The scene's name where it can name a folder; otherwise what remains of it, with a hash that keeps two such apart.
std::string folder_name(std::string_view scene);

}  // namespace polhode::report
