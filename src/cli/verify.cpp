// SPDX-License-Identifier: Apache-2.0
// polhode verify: runs the experiments, writes the report, prints what came out.
#include "run/verify.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>

#include "cli/answers/json.hpp"
#include "cli/commands.hpp"
#include "cli/comparing.hpp"
#include "cli/kept/baseline.hpp"
#include "cli/kept/cache.hpp"
#include "cli/kept/user_folders.hpp"
#include "cli/options/arguments.hpp"
#include "cli/terminal/forecast_table.hpp"
#include "cli/terminal/profile_table.hpp"
#include "cli/terminal/progress.hpp"
#include "cli/terminal/signals.hpp"
#include "cli/terminal/summary.hpp"
#include "cli/terminal/terminal.hpp"
#include "cli/together.hpp"
#include "cli/verify_arguments.hpp"
#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"
#include "reports/writers/comparison_text.hpp"
#include "reports/writers/folder.hpp"
#include "reports/writers/json.hpp"
#include "scene/nearest.hpp"

namespace polhode::cli {
namespace {

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

std::string text_of(std::span<const report::results> all, const std::filesystem::path& out) {
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
    print(text_of(all, given.out));
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

int run(const verify_arguments& given) {
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
  return {&parser, [given] { return run(*given); }, true};
}

}  // namespace polhode::cli
