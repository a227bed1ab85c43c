// SPDX-License-Identifier: Apache-2.0
// The folder of a simulation: complete or not there, as for reports.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "reports/model/simulation.hpp"

namespace polhode::report {

// The files of a simulation, made and written side by side.

/// How a simulation's snapshots are written.
struct snapshot_style {
  std::size_t colour_map = 0;  ///< of colour_maps()
  bool as_text = false;        ///< histograms as CSV rather than NPY
};

/// "final.csv" or, above 100000 bodies, "final.npy".
std::string final_name(const simulation&);

/// Into a folder that stands there, on as many threads as the simulation had. Throws output_error, which names the
/// folder as `known_as`.
void write_simulation_files(const std::filesystem::path& folder, const simulation&, const snapshot_style&,
                            const std::filesystem::path& known_as);

/// The run itself, which may record into a file that stands in the folder already: recorded_npy or recorded_csv.
using run_into_folder = std::function<simulation(const std::filesystem::path& folder)>;
inline constexpr const char *recorded_npy = "recorded.npy", *recorded_csv = "recorded.csv";

/// Writes final.csv (final.npy above 100000 bodies), summary.json, and snapshot_<time>.npy (or .csv) and .png for each
/// snapshot. A folder of ours that stands there is exchanged in one step. Throws input_error where it holds anything
/// else, output_error where the disk refuses; neither leaves a trace.
void write_simulation(const std::filesystem::path& out, const simulation&, const snapshot_style& = {});
/// The same of what `run` hands back, together with what it wrote there itself.
simulation write_simulation(const std::filesystem::path& out, const run_into_folder& run, const snapshot_style& = {});

/// The same refusals, before the work starts. Creates nothing.
void check_simulation_folder(const std::filesystem::path& out);

}  // namespace polhode::report
