// SPDX-License-Identifier: Apache-2.0
// Results files as the command line names them.
#pragma once

#include <filesystem>

#include "reports/model/results.hpp"

namespace polhode::cli {

/// The file that is meant: a folder stands for the results.json in it, or its digest.json where that is all.
std::filesystem::path results_file(const std::filesystem::path&);

/// A results.json or digest.json, or the folder of a scene that holds one. Throws input_error, on one line, with the file's name.
report::results read_results(const std::filesystem::path&);

}  // namespace polhode::cli
