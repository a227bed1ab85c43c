// SPDX-License-Identifier: Apache-2.0
#include "cli/options/integrators.hpp"

#include <fmt/format.h>

#include "cli/options/arguments.hpp"
#include "cli/terminal/terminal.hpp"
#include "foreign/open.hpp"
#include "foreign/process.hpp"
#include "reports/model/errors.hpp"
#include "systems/systems.hpp"

namespace polhode::cli {
namespace {

constexpr double longest_deadline = 86400;

double deadline_of(const integrator_arguments& given) {
  if (!given.deadline) return foreign::usual_deadline;
  if (given.with.empty()) throw input_error("--deadline: is for commands; accepted: with --with");
  const double seconds = positive_option("--deadline", *given.deadline);
  if (seconds > longest_deadline)
    throw input_error(
        fmt::format("--deadline {}: accepted: up to {} seconds", shown(*given.deadline), longest_deadline));
  return seconds;
}

}  // namespace

void add_integrators(CLI::App& parser, integrator_arguments& given) {
  add_option(parser, "--with", given.with, "An integrator of your own: a library (.so) or a command; repeatable",
             "FILE");
  add_option(parser, "--deadline", given.deadline, "Of a command: seconds for an answer [60]", "S");
}

foreign::foreign_schemes opened_integrators(const integrator_arguments& given) {
  const double deadline = deadline_of(given);
  foreign::foreign_schemes out;
  for (const auto& one : given.with)
    for (auto& scheme : foreign::open_integrators(one, deadline)) out.push_back(std::move(scheme));
  return out;
}

scene opened_scene(const std::string& name_or_path) {
  auto s = load_scene(name_or_path);
  const auto notice = find_system(s.system)->offers(s).notice;
  if (!notice.empty()) print_error(fmt::format("note: scene {}: {}", s.name, notice));
  return s;
}

}  // namespace polhode::cli
