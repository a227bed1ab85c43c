// SPDX-License-Identifier: Apache-2.0
#include "scene/scene.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"
#include "scene/builtin.hpp"
#include "scene/nearest.hpp"
#include "scene/scene_parse.hpp"

namespace polhode {
namespace {

constexpr std::size_t largest_file = std::size_t{1} << 20U;

[[noreturn]] void refuse_file(const std::string& path, std::string_view fault) {
  throw input_error(fmt::format("{}: {}; accepted: a readable TOML file of at most 1 MiB", one_line(path, 200), fault));
}

/// Without waiting for somebody who writes into a pipe that nobody has opened: it is an empty file.
std::FILE* open_file(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return nullptr;
  ::fcntl(descriptor, F_SETFL, O_RDONLY);
  return ::fdopen(descriptor, "rb");
}

/// Bounded, so that an endless device is refused like a huge file.
std::string read_file(const std::string& path) {
  const auto close = [](std::FILE* f) { std::fclose(f); };
  const std::unique_ptr<std::FILE, decltype(close)> file{open_file(path), close};
  if (!file) refuse_file(path, fmt::format("cannot be opened ({})", std::strerror(errno)));
  std::string text(largest_file + 1, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), file.get()));
  if (std::ferror(file.get()) != 0) refuse_file(path, fmt::format("cannot be read ({})", std::strerror(errno)));
  if (text.size() > largest_file) refuse_file(path, "is larger than 1 MiB");
  if (text.empty()) refuse_file(path, "is empty");
  return text;
}

[[noreturn]] void refuse_name(const std::string& name) {
  throw input_error(fmt::format("{}: no such scene{}, or the path of a TOML file",
                                name.empty() ? "''" : one_line(name, 200), accepted_instead(name, builtin_scenes())));
}

}  // namespace

scene load_scene(std::string_view name_or_path) {
  const std::string path{name_or_path};
  const bool could_be_name = path.find('/') == path.npos && !name_or_path.ends_with(".toml");
  if (could_be_name) {
    const auto table = builtin_scene_table();
    const auto found = std::ranges::find(table, name_or_path, &builtin_scene::name);
    if (found != table.end()) return parse_scene(found->text, fmt::format("built-in {}", path), path);
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) refuse_name(path);
  }
  return parse_scene(read_file(path), one_line(path, 200), std::filesystem::path{path}.stem().string());
}

std::vector<std::string> builtin_scenes() {
  std::vector<std::string> names;
  for (const auto& entry : builtin_scene_table()) names.emplace_back(entry.name);
  return names;
}

}  // namespace polhode
