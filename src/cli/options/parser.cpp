// SPDX-License-Identifier: Apache-2.0
#include "cli/options/parser.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <sstream>

#include "cli/options/arguments.hpp"
#include "cli/terminal/terminal.hpp"
#include "cli/together.hpp"
#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"
#include "run/provenance.hpp"
#include "scene/nearest.hpp"

namespace polhode::cli {
namespace {

constexpr auto exit_codes =
    "Exit codes: 0 all claims hold, 1 a claim is refuted, something got worse, or a published number\n"
    "            that should agree does not, 2 bad input, 3 nothing refuted but something inconclusive,\n"
    "            4 could not write or run";

std::string version() {
  const auto build = build_provenance();
  return fmt::format("polhode {} ({})", build.version, build.commit);
}

void set_up(CLI::App& app) {
  app.name("polhode");
  app.set_version_flag("--version", version, "Print the version and the commit, and exit");
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.require_subcommand(0, 1);
  app.footer(exit_codes);
  // What is left over is refused by us: in one line, with the nearest known name.
  app.allow_extras();
}

/// The parser's own words for what goes wrong with a value are not fit for a reader.
std::string fault_of(const CLI::ParseError& outcome) {
  const auto text = one_line(outcome.what(), 200);
  const auto option = text.substr(0, text.find(':'));
  if (outcome.get_name() == "ConversionError")  // "Could not convert: --quiet = maybe"
    return fmt::format("{}: a flag; accepted: without a value", text.substr(text.find(": ") + 2));
  if (outcome.get_name() != "ArgumentMismatch") return fmt::format("{}; see polhode --help", text);
  const bool repeated = text.find("received") != text.npos;
  return fmt::format("{}: {}", option,
                     repeated ? "given more than once; accepted: once" : "no value; accepted: one value");
}

/// The parser reports help and version as exceptions, too.
int parsed_otherwise(const CLI::App& app, const CLI::ParseError& outcome) {
  if (outcome.get_exit_code() != 0) throw input_error(fault_of(outcome));
  std::ostringstream text;
  app.exit(outcome, text, text);
  if (speaks()) print(text.str());
  return 0;
}

std::vector<std::string> long_options_of(const CLI::App& parser) {
  std::vector<std::string> names;
  for (const auto* option : parser.get_options())
    for (const auto& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

/// What the parser left over, without the mark that ends the options.
std::vector<std::string> rest_of(const CLI::App& parser) {
  auto rest = parser.remaining();
  std::erase(rest, "--");
  return rest;
}

void refuse_rest(const CLI::App& parser) {
  const auto rest = rest_of(parser);
  if (rest.empty()) return;
  const auto argument = rest.front().substr(0, rest.front().find('='));
  if (!argument.starts_with('-'))
    throw input_error(fmt::format("{} is one argument too many for {}", shown(argument), parser.get_name()));
  throw input_error(
      fmt::format("{}: unknown option{}", shown(argument), accepted_instead(argument, long_options_of(parser))));
}

void refuse_unknown(const CLI::App& root, std::span<const command> commands) {
  std::vector<std::string> names;
  for (const auto& c : commands) names.push_back(c.parser->get_name());
  const auto rest = rest_of(root);
  if (!rest.empty() && !rest.front().starts_with('-') && root.get_subcommands().empty())
    throw input_error(fmt::format("{}: unknown command{}", shown(rest.front()), accepted_instead(rest.front(), names)));
  refuse_rest(root);
  for (const auto* parser : root.get_subcommands()) refuse_rest(*parser);
  if (root.get_subcommands().empty())
    throw input_error(fmt::format("no command given; accepted: {}; see polhode --help", fmt::join(names, ", ")));
}

template <class Value>
void declare(CLI::App& parser, const std::string& name, Value& value, const std::string& help,
             const std::string& type) {
  parser.add_option(name, value, help)->type_name(type);
}

}  // namespace

int run_command(int argc, char** argv, const add_commands& add) {
  CLI::App app{"Verifies what stochastic geometric integrators claim."};
  set_up(app);
  const auto commands = add(app);
  for (const auto& c : commands) c.parser->allow_extras()->footer(exit_codes);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& outcome) {
    return parsed_otherwise(app, outcome);
  }
  refuse_unknown(app, commands);
  for (const auto& c : commands)
    if (c.parser->parsed()) return c.shared || speaks() ? c.run() : 0;
  return 0;
}

CLI::App& add_command(CLI::App& root, const std::string& name, const std::string& help) {
  return *root.add_subcommand(name, help);
}

void add_option(CLI::App& parser, const std::string& name, std::string& value, const std::string& help,
                const std::string& type) {
  declare(parser, name, value, help, type);
}

void add_option(CLI::App& parser, const std::string& name, std::optional<std::string>& value, const std::string& help,
                const std::string& type) {
  declare(parser, name, value, help, type);
}

void add_option(CLI::App& parser, const std::string& name, std::vector<std::string>& value, const std::string& help,
                const std::string& type) {
  declare(parser, name, value, help, type);
}

void add_flag(CLI::App& parser, const std::string& name, bool& value, const std::string& help) {
  parser.add_flag(name, value, help);
}

}  // namespace polhode::cli
