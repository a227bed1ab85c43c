// SPDX-License-Identifier: Apache-2.0
// polhode select: the cheapest scheme and step that meet a target on a scene, with the evidence.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>
#include <memory>

#include "cli/answers/json.hpp"
#include "cli/commands.hpp"
#include "cli/options/arguments.hpp"
#include "cli/options/integrators.hpp"
#include "cli/terminal/terminal.hpp"
#include "reports/model/errors.hpp"
#include "run/choose.hpp"

namespace polhode::cli {
namespace {

constexpr int nothing_meets_it = 3;

struct select_arguments {
  integrator_arguments integrators;
  std::string scene = "paper", goal, tolerance, observable = "all", time, require, threads, seed = "1", isa = "auto",
              format = "text";
};

std::string line_of(const choice& c) {
  return fmt::format(
      "{} at dt = {:.4g}: error {:.2g}, at most {:.2g} from there down to dt = {:.2g} (predicted {:.2g}); {:.3g} ns a "
      "path and unit of time\n",
      c.scheme, c.dt, c.checked, c.bound, c.checked_to, c.predicted, c.cost);
}

/// What the winner's errors are of, and what they say nothing about.
std::string scope_of(const selection& s) {
  if (!s.worst_observable) return "";
  const auto& w = *s.worst_observable;
  const auto when = w.time > 0 ? fmt::format(" at t = {:.3g}", w.time) : "";
  if (s.silent_on.empty()) return fmt::format("the worst observable is {}: {:.2g}{}\n", w.observable, w.bound(), when);
  return fmt::format("of {} alone; silent on {}, of which the worst is {}: {:.2g}{}{}\n", s.question.observable,
                     fmt::join(s.silent_on, ", "), w.observable, w.bound(), when,
                     w.bound() > s.question.tolerance
                         ? fmt::format(", {:.2g} times the tolerance", w.bound() / s.question.tolerance)
                         : "");
}

std::string shown_selection(const selection& s) {
  std::string out;
  if (s.winner) {
    out += line_of(*s.winner);
    if (s.runner_up)
      out += fmt::format("then {}", line_of(*s.runner_up));
    else
      out += "nothing else meets it\n";
    if (s.runner_up)
      out += s.tied ? "the two are tied: the intervals of their costs overlap\n"
                    : fmt::format("the first costs {:.2f} times less\n", s.runner_up->cost / s.winner->cost);
  } else {
    out += fmt::format("nothing meets {} {:g}: {}\n", s.question.name, s.question.tolerance, s.reason);
  }
  out += '\n' + scope_of(s);
  for (const auto& n : s.notes) out += n + '\n';
  for (const auto& r : s.rejected) out += fmt::format("  {:<20} {}\n", r.scheme, r.reason);
  return s.snippet.empty() ? out : out + '\n' + s.snippet;
}

int run_select(const select_arguments& given) {
  const auto output = format_option(given.format);
  select_options options;
  options.goal = given.goal;
  if (given.tolerance.empty()) throw input_error("--tolerance is missing; accepted: a number above 0");
  options.tolerance = positive_option("--tolerance", given.tolerance);
  options.observable = given.observable;
  if (!given.time.empty()) options.time = positive_option("--time", given.time);
  options.require = list_option("--require", given.require);
  options.threads = threads_option(given.threads);
  options.seed = integer_option("--seed", given.seed, 0, std::numeric_limits<std::uint64_t>::max());
  options.isa = given.isa;
  options.foreign = opened_integrators(given.integrators);
  const auto found = select(opened_scene(given.scene), options);
  print(output == format::json ? to_json(found) : shown_selection(found));
  return found.winner ? 0 : nothing_meets_it;
}

}  // namespace

command add_select(CLI::App& app) {
  const auto given = std::make_shared<select_arguments>();
  given->threads = default_threads();
  auto& parser = add_command(app, "select", "The cheapest scheme and step for a target, measured on a scene");
  add_option(parser, "SCENE", given->scene, "A built-in name or a TOML file [paper]", "");
  add_integrators(parser, given->integrators);
  add_option(parser, "--goal", given->goal, "strong, weak, stationary, energy", "G");
  add_option(parser, "--tolerance", given->tolerance,
             "Of the error, in units of the observable's size, of |Pi_0| or of h_0", "X");
  add_option(parser, "--observable", given->observable, "Of weak and stationary: one alone [all: the worst]", "NAME");
  add_option(parser, "--time", given->time, "Of strong, weak and energy [the horizon]", "T");
  add_option(parser, "--require", given->require, "casimir-exact,explicit,implicit,no-areas,monotone-energy", "A,B");
  add_option(parser, "--threads", given->threads, "Working threads [all processors]", "N");
  add_option(parser, "--seed", given->seed, "Of every random number [1]", "N");
  add_option(parser, "--isa", given->isa, "Instruction set of the inner loops [auto]", "I");
  add_option(parser, "--format", given->format, "text, json [text]", "F");
  return {&parser, [given] { return run_select(*given); }};
}

}  // namespace polhode::cli
