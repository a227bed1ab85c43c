// Where the command keeps results between runs.
#pragma once

#include <filesystem>
#include <memory>

#include "reports/writers/result_folder.hpp"

namespace polhode::cli {

/// $POLHODE_CACHE, else $XDG_CACHE_HOME/polhode, else ~/.cache/polhode; empty where none of them is set.
std::filesystem::path cache_folder();

/// The store in cache_folder(); null where there is none. Throws input_error where that lies in the output folder.
std::unique_ptr<report::result_folder> open_cache(report::result_folder::access, const std::filesystem::path& out);

}  // namespace polhode::cli
