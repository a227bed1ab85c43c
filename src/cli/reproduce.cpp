// SPDX-License-Identifier: Apache-2.0
// polhode reproduce: published figures beside ours, a verdict each.
#include "reproduction/reproduce.hpp"

#include <unistd.h>

#include <filesystem>
#include <limits>
#include <memory>

#include "cli/commands.hpp"
#include "cli/options/arguments.hpp"
#include "cli/terminal/progress.hpp"
#include "cli/terminal/reproduction_table.hpp"
#include "cli/terminal/signals.hpp"
#include "cli/terminal/terminal.hpp"
#include "reports/model/errors.hpp"
#include "reports/writers/reproduction_folder.hpp"
#include "reports/writers/reproduction_json.hpp"
#include "scene/nearest.hpp"

namespace polhode::cli {
namespace {

struct reproduce_arguments {
  std::vector<std::string> cases;
  std::optional<std::string> out;
  std::string effort = "standard", threads, seed = "1", format = "text";
  bool quiet = false;
};

reproduce_options reproduce_options_of(const reproduce_arguments& given) {
  static const std::vector<std::string> efforts{"quick", "standard", "thorough"};
  reproduce_options options;
  options.effort = static_cast<effort>(choose("--effort", given.effort, efforts));
  options.threads = threads_option(given.threads);
  options.seed = integer_option("--seed", given.seed, 0, std::numeric_limits<std::uint64_t>::max());
  return options;
}

std::vector<report::reproduction> run_them(const std::vector<std::size_t>& cases, const reproduce_options& options,
                                           bool quiet) {
  progress_line progress{!quiet};
  return reproduce(cases, options, [&](double share, std::string_view what) { progress.show(share, what); });
}

int run_reproduce(const reproduce_arguments& given) {
  const auto output = format_option(given.format);
  const auto options = reproduce_options_of(given);
  const auto cases = chosen_reproductions(given.cases);
  if (given.out) {
    if (given.out->empty()) throw input_error("--out '': accepted: the folder to be written");
    report::check_reproduction_folder(*given.out);
  }
  const auto found = run_them(cases, options, given.quiet);
  if (given.out) {
    const defer_signals whole;
    report::write_reproductions(*given.out, found);
  }
  if (output == format::json)
    print(report::to_json(found));
  else if (!given.quiet)
    print(to_text(found, terminal_width(STDOUT_FILENO)));
  return exit_code(found);
}

}  // namespace

command add_reproduce(CLI::App& app) {
  const auto given = std::make_shared<reproduce_arguments>();
  given->threads = default_threads();
  auto& parser = add_command(app, "reproduce", "Published figures of the field beside ours, a verdict each");
  add_option(parser, "CASE", given->cases, "See polhode list reproductions [all]", "");
  add_option(parser, "--out", given->out, "Write a page of them, as HTML, Markdown and JSON", "DIR");
  add_option(parser, "--effort", given->effort, "quick, standard, thorough [standard]", "E");
  add_option(parser, "--threads", given->threads, "1 to 1024 [" + given->threads + "]", "N");
  add_option(parser, "--seed", given->seed, "Seed of the noise [1]", "N");
  add_option(parser, "--format", given->format, "On standard output: text, json [text]", "F");
  add_flag(parser, "-q,--quiet", given->quiet, "No table, no progress");
  return {&parser, [given] { return run_reproduce(*given); }};
}

}  // namespace polhode::cli
