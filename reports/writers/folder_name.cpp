// SPDX-License-Identifier: Apache-2.0
// How a scene's name, which may be any text, becomes the name of a folder.
#include <fmt/format.h>

#include <cstdint>

#include "reports/writers/folder.hpp"

namespace polhode::report {

std::string folder_name(std::string_view scene) {
  constexpr std::size_t longest = 80;
  constexpr std::string_view allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-+=@";
  std::string name;
  for (const char c : scene.substr(0, longest)) {
    if (allowed.find(c) != std::string_view::npos && !(name.empty() && (c == '.' || c == '-')))
      name += c;
    else if (!name.empty() && name.back() != '_')
      name += '_';
  }
  if (name == scene && !name.empty()) return name;
  std::uint32_t hash = 2166136261u;  // FNV-1a
  for (const char c : scene) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
  while (!name.empty() && name.back() == '_') name.pop_back();
  return fmt::format("{}-{:08x}", name.empty() ? "scene" : name, hash);
}

}  // namespace polhode::report
