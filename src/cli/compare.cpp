// SPDX-License-Identifier: Apache-2.0
// polhode compare: what has changed between two results of one scene, beyond noise.
#include "comparison/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "cli/commands.hpp"
#include "cli/comparing.hpp"
#include "cli/kept/read_results.hpp"
#include "cli/options/arguments.hpp"
#include "cli/terminal/terminal.hpp"
#include "reports/model/errors.hpp"
#include "reports/writers/comparison_json.hpp"
#include "reports/writers/comparison_text.hpp"
#include "reports/writers/disk.hpp"
#include "reports/writers/html.hpp"
#include "reports/writers/output_folder.hpp"

namespace polhode::cli {
namespace {

struct compare_arguments {
  std::string before, after, format = "text";
  std::optional<std::string> html;
};

/// Where the page is to be written, if anywhere: refused before any work, and never over what is compared.
std::optional<std::filesystem::path> page_option(const compare_arguments& given) {
  if (!given.html) return std::nullopt;
  auto page = report::settled_file(*given.html);
  for (const auto& one : {given.before, given.after}) {
    std::error_code none;
    if (std::filesystem::equivalent(page, results_file(one), none))
      throw input_error(
          fmt::format("compare: --html {} is one of the two results; accepted: another file", report::quoted(page)));
  }
  return page;
}

int run_compare(const compare_arguments& given) {
  const auto output = format_option(given.format);
  if (given.before.empty() || given.after.empty())
    throw input_error("compare: two results are needed; accepted: compare OLD NEW, each a results.json or its folder");
  const auto page = page_option(given);
  const auto before = read_results(given.before), after = read_results(given.after);
  const std::array found{compare(before, after)};
  if (page) report::disk::replace_file(*page, report::to_html(before, after, found.front()), *given.html);
  print(output == format::json ? report::to_json(found) : report::to_text(found.front()));
  return exit_code(found);
}

}  // namespace

int exit_code(std::span<const report::comparison> all) {
  const auto has = [&](report::change_kind kind) {
    return std::ranges::any_of(all, [&](const auto& c) {
      return std::ranges::find(c.changes, kind, &report::change::kind) != c.changes.end();
    });
  };
  return has(report::change_kind::worse) ? 1 : has(report::change_kind::unsure) ? 3 : 0;
}

command add_compare(CLI::App& app) {
  const auto given = std::make_shared<compare_arguments>();
  auto& parser = add_command(app, "compare", "Two results of one scene: what has changed, beyond noise");
  add_option(parser, "OLD", given->before, "A results.json, or the folder of a scene", "");
  add_option(parser, "NEW", given->after, "The same, later", "");
  add_option(parser, "--html", given->html, "Write the report of NEW, with OLD beside it, as one page", "FILE");
  add_option(parser, "--format", given->format, "text, json [text]", "F");
  return {&parser, [given] { return run_compare(*given); }};
}

}  // namespace polhode::cli
