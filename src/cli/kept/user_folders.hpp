// SPDX-License-Identifier: Apache-2.0
// What the command keeps for its user between runs, and where.
#pragma once

#include <filesystem>
#include <string_view>

namespace polhode::cli {

/// $POLHODE_CACHE, else $XDG_CACHE_HOME/polhode, else ~/.cache/polhode; empty where none of them is set.
std::filesystem::path cache_folder();

/// The report folder of a named baseline: in $POLHODE_BASELINES, else $XDG_DATA_HOME/polhode/baselines, else
/// ~/.local/share/polhode/baselines. Throws input_error, naming the option, for a name that is no file name and where
/// there is no such place.
std::filesystem::path baseline_folder(std::string_view option, std::string_view name);

}  // namespace polhode::cli
