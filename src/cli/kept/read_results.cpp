// SPDX-License-Identifier: Apache-2.0
#include "cli/kept/read_results.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"
#include "reports/writers/json.hpp"

namespace polhode::cli {

std::filesystem::path results_file(const std::filesystem::path& given) {
  std::error_code ignored;
  return std::filesystem::is_directory(given, ignored) ? given / "results.json" : given;
}

report::results read_results(const std::filesystem::path& given) {
  const auto file = results_file(given);
  const auto name = one_line(file.string(), 200);
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw input_error(fmt::format("{}: cannot be read; accepted: a results.json, or the folder of a scene", name));
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  try {
    return report::from_json(text);
  } catch (const input_error& fault) {
    throw input_error(fmt::format("{}: {}", name, fault.what()));
  }
}

}  // namespace polhode::cli
