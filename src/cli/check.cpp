// SPDX-License-Identifier: Apache-2.0
// polhode check: recorded data against a scene's equation.
#include "run/check.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <memory>
#include <span>

#include "cli/answers/json.hpp"
#include "cli/commands.hpp"
#include "cli/options/arguments.hpp"
#include "cli/options/integrators.hpp"
#include "cli/terminal/layout.hpp"
#include "cli/terminal/signals.hpp"
#include "cli/terminal/summary.hpp"
#include "cli/terminal/terminal.hpp"
#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"
#include "reports/writers/folder.hpp"

namespace polhode::cli {
namespace {

struct check_arguments {
  std::string data, scene, format = "text";
  std::optional<std::string> dt, out;
  bool quiet = false;
};

std::string shown_check(const checked_recording& checked) {
  const auto width = terminal_width(STDOUT_FILENO);
  std::string out;
  for (const auto& v : checked.results.verdicts)
    out += wrapped(fmt::format("{}: {} ({})", v.claim, report::name_of(v.kind), v.reason), width) + '\n';
  if (checked.equation.parameters.empty()) return out;
  out += fmt::format("\n{:<16} {:>12} {:>12} {:>12} {:>12}\n", "the data follow", "value", "low", "high", "scene");
  for (const auto& p : checked.equation.parameters)
    out += p.held ? fmt::format("{:<16} {:>12} {:>25} {:>12.6g}\n", p.name, "held", "", p.in_scene)
                  : fmt::format("{:<16} {:>12.6g} {:>12.6g} {:>12.6g} {:>12.6g}\n", p.name, p.value.value, p.value.low,
                                p.value.high, p.in_scene);
  return out;
}

int run_check(const check_arguments& given) {
  const auto output = format_option(given.format);
  if (given.data.empty()) throw input_error("DATA is missing; accepted: a file of recorded states, .csv or .npy");
  if (given.scene.empty()) throw input_error("--scene is missing; accepted: a built-in name or a TOML file");
  std::optional<double> dt;
  if (given.dt) dt = positive_option("--dt", *given.dt);
  if (given.out) {
    if (given.out->empty()) throw input_error("--out '': accepted: the folder to be written");
    report::check_output_folder(*given.out);
  }
  const auto checked = check(opened_scene(given.scene), given.data, dt);
  const std::span one(&checked.results, 1);
  if (given.out) {
    const defer_signals whole;
    report::write_report(*given.out, one);
  }
  if (output == format::json)
    print(to_json(checked));
  else if (!given.quiet)
    print(shown_check(checked));
  return exit_code(one);
}

}  // namespace

command add_check(CLI::App& app) {
  const auto given = std::make_shared<check_arguments>();
  auto& parser = add_command(app, "check", "Hold recorded data against a scene's equation");
  add_option(parser, "DATA", given->data, "Recorded states: .csv ([path,]t,mu_1,…) or .npy [path, time, component]",
             "");
  add_option(parser, "--scene", given->scene, "A built-in name or a TOML file", "SCENE");
  add_option(parser, "--dt", given->dt, "Time from state to state, of an .npy", "H");
  add_option(parser, "--out", given->out, "Write the report of it", "DIR");
  add_option(parser, "--format", given->format, "On standard output: text, json [text]", "F");
  add_flag(parser, "-q,--quiet", given->quiet, "No summary");
  return {&parser, [given] { return run_check(*given); }};
}

}  // namespace polhode::cli
