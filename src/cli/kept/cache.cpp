// SPDX-License-Identifier: Apache-2.0
#include "cli/kept/cache.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/kept/user_folders.hpp"
#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"

namespace polhode::cli {
namespace {

namespace fs = std::filesystem;

/// Whether `inner` is `outer` or lies in it, links followed as far as they exist.
bool lies_in(const fs::path& inner, const fs::path& outer) {
  std::error_code ignored;
  const auto canonical = [&](const fs::path& p) {
    return (fs::weakly_canonical(fs::absolute(p), ignored) / "").parent_path();
  };
  const auto i = canonical(inner), o = canonical(outer);
  return std::ranges::mismatch(o, i).in1 == o.end();
}

}  // namespace

fs::path cache_beside(const fs::path& out) {
  auto folder = cache_folder();
  if (!folder.empty() && !out.empty() && lies_in(folder, out))
    throw input_error(fmt::format(
        "cache folder '{}': lies in the output folder; accepted: POLHODE_CACHE or --out elsewhere, or --no-cache",
        one_line(folder.string(), 200)));
  return folder;
}

std::unique_ptr<report::result_folder> open_cache(report::result_folder::access how, const fs::path& out) {
  const auto folder = cache_beside(out);
  return folder.empty() ? nullptr : std::make_unique<report::result_folder>(folder, how);
}

}  // namespace polhode::cli
