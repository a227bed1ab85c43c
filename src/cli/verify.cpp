// SPDX-License-Identifier: Apache-2.0
// polhode verify: runs the experiments, writes the report, prints what came out.
#include "run/verify.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/answers/json.hpp"
#include "cli/commands.hpp"
#include "cli/comparing.hpp"
#include "cli/kept/baseline.hpp"
#include "cli/kept/cache.hpp"
#include "cli/kept/user_folders.hpp"
#include "cli/options/arguments.hpp"
#include "cli/options/integrators.hpp"
#include "cli/options/parser.hpp"
#include "cli/terminal/forecast_table.hpp"
#include "cli/terminal/profile_table.hpp"
#include "cli/terminal/progress.hpp"
#include "cli/terminal/signals.hpp"
#include "cli/terminal/summary.hpp"
#include "cli/terminal/terminal.hpp"
#include "cli/together.hpp"
#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"
#include "reports/writers/comparison_text.hpp"
#include "reports/writers/folder.hpp"
#include "reports/writers/json.hpp"
#include "scene/nearest.hpp"

namespace polhode::cli {
namespace {

// What `polhode verify` is asked for.

/// These stand as they were given: they are checked in one place, so that every fault reads alike.
struct verify_arguments {
  std::vector<std::string> scenes;
  std::string schemes, experiments, effort = "standard", out = "report", threads, seed = "1", isa = "auto",
                                    generator = "philox", format = "text", progress = "auto";
  integrator_arguments integrators;
  std::optional<std::string> baseline, save_baseline, budget;
  bool fresh = false, no_cache = false, quiet = false, latex = false, profile = false, forecast = false;
};

// Throw input_error of one line.
verify_options checked_options(const verify_arguments& given) {
  static const std::vector<std::string> efforts{"quick", "standard", "thorough"};
  verify_options options;
  options.schemes = list_option("--schemes", given.schemes);
  options.experiments = list_option("--experiments", given.experiments);
  options.effort = static_cast<effort>(choose("--effort", given.effort, efforts));
  options.threads = threads_option(given.threads);
  options.seed = integer_option("--seed", given.seed, 0, std::numeric_limits<std::uint64_t>::max());
  options.isa = given.isa;
  options.generator = given.generator;
  options.profile = given.profile;
  if (given.budget) options.budget = std::make_shared<time_budget>(positive_option("--budget", *given.budget));
  options.foreign = opened_integrators(given.integrators);
  return options;
}

std::vector<scene> checked_scenes(const verify_arguments& given) {
  std::vector<scene> scenes;
  for (const auto& name : given.scenes) {
    auto loaded = opened_scene(name);
    const auto folder_of = [](const scene& s) { return report::folder_name(s.name); };
    if (std::ranges::find(scenes, folder_of(loaded), folder_of) != scenes.end())
      throw input_error(fmt::format(
          "{}: name = '{}': another scene has it; accepted: names that differ, as each scene has its folder",
          one_line(name, 200), loaded.name));
    scenes.push_back(std::move(loaded));
  }
  return scenes;
}

/// Defaults, and the options that change them.
void add_verify_arguments(CLI::App& parser, verify_arguments& given) {
  given.scenes = {"paper"};
  given.threads = default_threads();
  add_option(parser, "SCENE", given.scenes, "Built-in names or TOML files [paper]", "");
  add_option(parser, "--schemes", given.schemes, "Only these schemes", "A,B");
  add_option(parser, "--experiments", given.experiments, "Only these experiments", "X,Y");
  add_integrators(parser, given.integrators);
  add_option(parser, "--effort", given.effort, "quick, standard, thorough [standard]", "E");
  add_option(parser, "--out", given.out, "Folder for the report [report]", "DIR");
  add_option(parser, "--threads", given.threads, "1 to 1024 [" + given.threads + "]", "N");
  add_option(parser, "--seed", given.seed, "Seed of the noise [1]", "N");
  add_option(parser, "--generator", given.generator, "Random bits: philox, ars [philox]", "NAME");
  add_option(parser, "--isa", given.isa, "Instruction set: auto, v2, v3, v4 [auto]", "NAME");
  add_option(parser, "--baseline", given.baseline, "Compare with what has this name", "NAME");
  add_option(parser, "--save-baseline", given.save_baseline, "Keep the results under this name", "NAME");
  add_option(parser, "--budget", given.budget, "Seconds; what is not done by then is left out", "S");
  add_option(parser, "--format", given.format, "On standard output: text, json [text]", "F");
  add_option(parser, "--progress", given.progress, "auto: on terminals; lines: one an experiment [auto]", "P");
  add_flag(parser, "--latex", given.latex, "Write report.tex, too: tables and plots for a paper");
  add_flag(parser, "--profile", given.profile, "Say where the processor time went");
  add_flag(parser, "--forecast", given.forecast, "Say what each experiment would cost, and end");
  add_flag(parser, "--fresh", given.fresh, "Compute all anew and replace what is cached");
  add_flag(parser, "--no-cache", given.no_cache, "Neither use the cache nor write to it");
  add_flag(parser, "-q,--quiet", given.quiet, "No summary, no progress");
}

/// "weak: 4 of 10 experiments after 12 s".
std::string told_of(const report::results& r) {
  const auto done = r.experiments.size();
  const auto begun = [&](const std::string& name) {
    return std::ranges::find(r.experiments, name, &report::experiment::name) != r.experiments.end();
  };
  const auto rest = r.to_come.size() - static_cast<std::size_t>(std::ranges::count_if(r.to_come, begun));
  return fmt::format("{}: {} of {} experiments after {}", r.experiments.back().name, done, done + rest,
                     duration_text(r.provenance.wall_seconds));
}

void write_whole(const verify_arguments& given, std::span<const report::results> all) {
  const defer_signals whole;
  report::write_report(given.out, all, given.latex ? report::latex::yes : report::latex::no);
}

/// What is there when a signal ends the run while scene number `at` is at work.
void prepare_to_stop(std::span<const scene> scenes, std::size_t at, bool begun, const verify_arguments& given) {
  if (given.quiet) return;
  const bool some = begun || at > 0;
  auto words = some ? fmt::format("stopped: {} holds what was finished by then", given.out)
                    : "stopped before anything was finished";
  std::vector<std::string> rest;
  for (const auto& scene : scenes.subspan(at + 1)) rest.push_back(scene.name);
  if (!rest.empty()) words += fmt::format(", nothing yet of {}", fmt::join(rest, ", "));
  if (!given.no_cache && some) words += "; the same command goes on from there";
  say_when_stopped(words);
}

void keep(std::span<const scene> scenes, std::span<const report::results> all, std::size_t at, bool begun,
          const verify_arguments& given) {
  const defer_signals both;
  write_whole(given, all);
  prepare_to_stop(scenes, at, begun, given);
}

/// The report grows: it is there after the first experiment, its scene marked unfinished until the last.
std::vector<report::results> run_all(std::span<const scene> scenes, verify_options options,
                                     const verify_arguments& given) {
  std::vector<report::results> all;
  const bool notes = given.progress == "lines" && !given.quiet;
  progress_line progress{!given.quiet && !notes};
  prepare_to_stop(scenes, 0, false, given);
  for (const auto& scene : scenes) {
    const auto label = [&](std::string_view what) {
      return scenes.size() == 1 ? std::string{what} : fmt::format("{}: {}", scene.name, what);
    };
    const auto sink = [&](double share, std::string_view what) {
      progress.show((static_cast<double>(all.size()) + share) / static_cast<double>(scenes.size()), label(what));
    };
    options.so_far = [&](const report::results& part) {
      all.push_back(part);
      keep(scenes, all, all.size() - 1, true, given);
      all.pop_back();
      if (notes) progress_note(label(told_of(part)));
    };
    options.beforehand = [&](const std::vector<expected_cost>& costs) {
      if (!given.quiet && options.among == nullptr)  // it is of one process
        print_aside(long_run_note(scene.name, costs, options.threads, terminal_width(STDERR_FILENO)));
    };
    all.push_back(verify(scene, options, sink));
    if (notes) progress_note(label(told_of(all.back())));
    if (all.size() < scenes.size()) keep(scenes, all, all.size(), false, given);
  }
  return all;
}

/// Null with --no-cache.
std::unique_ptr<report::result_folder> cache_for(const verify_arguments& given, const std::filesystem::path& out) {
  using access = report::result_folder::access;
  return given.no_cache ? nullptr : open_cache(given.fresh ? access::rewrite : access::use, out);
}

std::string json_of(std::span<const report::results> all) {
  if (all.size() == 1) return report::to_json(all.front()) + '\n';
  std::string out = "[";
  for (const auto& r : all) out += (out.size() == 1 ? "\n" : ",\n") + report::to_json(r);
  return out + "\n]\n";
}

std::string shown_reports(std::span<const report::results> all, const std::filesystem::path& out) {
  const auto width = terminal_width(STDOUT_FILENO);
  std::string text;
  for (const auto& r : all) {
    const auto page = out / report::folder_name(r.scene.name) / "report.html";
    text +=
        summary(r, width) + profile_table(r.profile, width) + fmt::format("report: {}\n\n", one_line(page.string()));
  }
  text.pop_back();
  return text;
}

/// Of two exit codes: refuted (1) before inconclusive (3) before all well.
int worse_of(int a, int b) { return a == 1 || b == 1 ? 1 : std::max(a, b); }

void print_all(const verify_arguments& given, std::span<const report::results> all,
               std::span<const report::comparison> compared) {
  const bool json = format_option(given.format) == format::json;
  if (json)
    print(json_of(all));
  else if (!given.quiet)
    print(shown_reports(all, given.out));
  if (given.quiet) return;
  for (const auto& c : compared) {
    const auto text = report::to_text(c);
    json ? print_aside(text) : print('\n' + text);
  }
}

/// What is kept from earlier runs costs nothing.
int tell_costs(std::span<const scene> scenes, const verify_options& options, const verify_arguments& given) {
  std::string text, rows;
  for (const auto& scene : scenes) {
    const auto costs = expected_costs(scene, options);
    text +=
        (text.empty() ? "" : "\n") + forecast_table(scene.name, costs, options.threads, terminal_width(STDOUT_FILENO));
    rows += (rows.empty() ? "" : ",\n") + to_json(scene.name, costs, options.threads);
  }
  const bool json = format_option(given.format) == format::json;
  print(!json ? text : scenes.size() == 1 ? rows + '\n' : "[\n" + rows + "\n]\n");
  return 0;
}

/// Of one that does not speak: its share of the work, in the same order.
int take_part(std::span<const scene> scenes, const verify_options& options) {
  for (const auto& scene : scenes) verify(scene, options);
  return 0;
}

int run_verify(const verify_arguments& given) {
  format_option(given.format);
  choose("--progress", given.progress, std::array<std::string, 2>{"auto", "lines"});
  auto options = checked_options(given);
  const auto scenes = checked_scenes(given);
  for (const auto& scene : scenes) check_options(scene, options);
  options.among = others();
  if (!speaks()) return given.forecast ? 0 : take_part(scenes, options);
  if (given.out.empty()) throw input_error("--out '': accepted: the folder to be written");
  const std::filesystem::path out{given.out};
  report::check_output_folder(out);
  const baseline earlier(given.baseline, given.save_baseline, scenes);
  const auto cache = cache_for(given, out);
  options.store = cache.get();

  if (given.forecast) return tell_costs(scenes, options, given);

  const auto all = run_all(scenes, options, given);
  const auto compared = earlier.compare(all);
  {
    const defer_signals whole;
    write_whole(given, all);
    earlier.save(all);
    say_when_stopped("");
  }
  if (cache && !cache->trouble().empty())
    print_error(
        fmt::format("results are not kept for the next run: {}: {}", cache_folder().string(), cache->trouble()));
  print_all(given, all, compared);
  return worse_of(exit_code(all), exit_code(compared));
}

}  // namespace

command add_verify(CLI::App& app) {
  const auto given = std::make_shared<verify_arguments>();
  auto& parser = add_command(app, "verify", "Hold the claims of the schemes against scenes");
  add_verify_arguments(parser, *given);
  return {&parser, [given] { return run_verify(*given); }, true};
}

}  // namespace polhode::cli
