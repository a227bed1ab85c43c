// polhode: parses the command line, runs one command, turns every outcome into an exit code.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <new>
#include <sstream>

#include "cli/arguments.hpp"
#include "cli/signals.hpp"
#include "cli/terminal.hpp"
#include "registry/provenance.hpp"
#include "reports/model/errors.hpp"

namespace polhode::cli {
namespace {

constexpr int bad_input = 2, cannot_run = 4;

constexpr auto exit_codes =
    "Exit codes: 0 all claims hold, 1 a claim is refuted, or something got worse, 2 bad input,\n"
    "            3 nothing refuted but something inconclusive, 4 could not write or run";

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
  const std::string text = outcome.what();
  const auto option = text.substr(0, text.find(':'));
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
  print(text.str());
  return 0;
}

int run(int argc, char** argv) {
  CLI::App app{"Verifies what stochastic geometric integrators claim."};
  set_up(app);
  const std::vector<command> commands{add_verify(app), add_simulate(app), add_reference(app),
                                      add_select(app), add_compare(app),  add_list(app)};
  for (const auto& c : commands) c.parser->allow_extras()->footer(exit_codes);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& outcome) {
    return parsed_otherwise(app, outcome);
  }
  refuse_unknown(app, commands);
  for (const auto& c : commands)
    if (c.parser->parsed()) return c.run();
  return 0;
}

}  // namespace

int guarded(int argc, char** argv) noexcept {
  try {
    return run(argc, argv);
  } catch (const input_error& fault) {
    print_error(fault.what());
    return bad_input;
  } catch (const std::bad_alloc&) {
    print_error("out of memory");
  } catch (const std::exception& fault) {
    print_error(fault.what());
  } catch (...) {
    print_error("stopped by an unknown fault");
  }
  return cannot_run;
}

}  // namespace polhode::cli

int main(int argc, char** argv) {
  polhode::cli::hold_standard_streams();
  polhode::cli::install_signal_handlers();
  return polhode::cli::guarded(argc, argv);
}
