// SPDX-License-Identifier: Apache-2.0
#include "cli/kept/read_results.hpp"

#include <fmt/format.h>

#include <fstream>
#include <ios>
#include <iterator>
#include <optional>
#include <string>
#include <system_error>

#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"
#include "reports/writers/json.hpp"

namespace polhode::cli {

std::filesystem::path results_file(const std::filesystem::path& given) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(given, ignored)) return given;
  const auto whole = given / "results.json", digest = given / "digest.json";
  return std::filesystem::exists(digest, ignored) && !std::filesystem::exists(whole, ignored) ? digest : whole;
}

namespace {

/// Nothing where it cannot be read, or where it has no end.
std::optional<std::string> text_of(const std::filesystem::path& file) {
  std::error_code ignored;
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_character_file(file, ignored)) return std::nullopt;
  try {
    return std::string{std::istreambuf_iterator<char>(in), {}};
  } catch (const std::ios_base::failure&) {
    return std::nullopt;
  }
}

}  // namespace

report::results read_results(const std::filesystem::path& given) {
  const auto file = results_file(given);
  const auto name = one_line(file.string(), 200);
  const auto text = text_of(file);
  if (!text)
    throw input_error(
        fmt::format("{}: cannot be read; accepted: a results.json or digest.json, or the folder of a scene", name));
  try {
    return report::from_json(*text);
  } catch (const input_error& fault) {
    throw input_error(fmt::format("{}: {}", name, fault.what()));
  }
}

}  // namespace polhode::cli
