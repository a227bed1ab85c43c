// SPDX-License-Identifier: Apache-2.0
// The files of a simulation, made and written side by side.
#pragma once

#include <filesystem>
#include <string>

#include "reports/model/simulation.hpp"

namespace polhode::report {

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

}  // namespace polhode::report
