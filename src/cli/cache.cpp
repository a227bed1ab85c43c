#include "cli/cache.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "registry/text.hpp"
#include "reports/model/errors.hpp"

namespace polhode::cli {
namespace {

namespace fs = std::filesystem;

fs::path variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// Whether `inner` is `outer` or lies in it, links followed as far as they exist.
bool lies_in(const fs::path& inner, const fs::path& outer) {
  std::error_code ignored;
  const auto settled = [&](const fs::path& p) {
    return (fs::weakly_canonical(fs::absolute(p), ignored) / "").parent_path();
  };
  const auto i = settled(inner), o = settled(outer);
  return std::ranges::mismatch(o, i).in1 == o.end();
}

}  // namespace

fs::path cache_folder() {
  if (const auto own = variable("POLHODE_CACHE"); !own.empty()) return fs::absolute(own);
  // The XDG specification has relative paths ignored.
  if (const auto xdg = variable("XDG_CACHE_HOME"); xdg.is_absolute()) return xdg / "polhode";
  if (const auto home = variable("HOME"); home.is_absolute()) return home / ".cache" / "polhode";
  return {};
}

std::unique_ptr<report::result_folder> open_cache(report::result_folder::access how, const fs::path& out) {
  const auto folder = cache_folder();
  if (folder.empty()) return nullptr;
  if (lies_in(folder, out))
    throw input_error(fmt::format(
        "cache folder '{}': lies in the output folder; accepted: POLHODE_CACHE or --out elsewhere, or --no-cache",
        one_line(folder.string(), 200)));
  return std::make_unique<report::result_folder>(folder, how);
}

}  // namespace polhode::cli
