// SPDX-License-Identifier: Apache-2.0
// Where the command keeps results between runs.
#pragma once

#include <filesystem>
#include <memory>

#include "reports/writers/result_folder.hpp"

namespace polhode::cli {

/// cache_folder(). Throws input_error where that lies in the output folder, if there is one.
std::filesystem::path cache_beside(const std::filesystem::path& out);

/// The store there; null where there is none.
std::unique_ptr<report::result_folder> open_cache(report::result_folder::access, const std::filesystem::path& out);

}  // namespace polhode::cli
