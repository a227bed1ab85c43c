// SPDX-License-Identifier: Apache-2.0
#include "cli/kept/user_folders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"

namespace polhode::cli {
namespace {

namespace fs = std::filesystem;

fs::path variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// Our own variable, else a folder of ours in the one that the XDG base directory specification names, else its default
/// in the home folder. (The specification has relative paths ignored.)
fs::path user_folder(const char* own, const char* xdg, const fs::path& in_home, const fs::path& ours) {
  if (const auto given = variable(own); !given.empty()) return fs::absolute(given);
  if (const auto base = variable(xdg); base.is_absolute()) return base / ours;
  if (const auto home = variable("HOME"); home.is_absolute()) return home / in_home / ours;
  return {};
}

}  // namespace

fs::path cache_folder() { return user_folder("POLHODE_CACHE", "XDG_CACHE_HOME", ".cache", "polhode"); }

fs::path baseline_folder(std::string_view option, std::string_view name) {
  const bool plain = !name.empty() && name.size() <= 64 && name.front() != '.' && std::ranges::all_of(name, [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' || c == '.';
  });
  if (!plain)
    throw input_error(fmt::format("{} '{}': accepted: a name of up to 64 letters, digits, '-', '_', '.'", option,
                                  one_line(name, 60)));
  const auto base = user_folder("POLHODE_BASELINES", "XDG_DATA_HOME", ".local/share", "polhode/baselines");
  if (base.empty())
    throw input_error(fmt::format("{}: no place for baselines; accepted: POLHODE_BASELINES or HOME set", option));
  return base / name;
}

}  // namespace polhode::cli
