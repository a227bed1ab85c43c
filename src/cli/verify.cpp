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

#include "cli/arguments.hpp"
#include "cli/baseline.hpp"
#include "cli/cache.hpp"
#include "cli/commands.hpp"
#include "cli/comparing.hpp"
#include "cli/profile_table.hpp"
#include "cli/progress.hpp"
#include "cli/signals.hpp"
#include "cli/summary.hpp"
#include "cli/terminal.hpp"
#include "cli/user_folders.hpp"
#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"
#include "reports/writers/comparison_text.hpp"
#include "reports/writers/folder.hpp"
#include "reports/writers/json.hpp"
#include "scene/nearest.hpp"

namespace polhode::cli {
namespace {

/// As given: checked in one place, so that every fault reads alike.
struct arguments {
  std::vector<std::string> scenes;
  std::string schemes, experiments, effort = "standard", out = "report", threads, seed = "1", isa = "auto",
                                    generator = "philox", format = "text", progress = "auto";
  std::optional<std::string> baseline, save_baseline;
  bool fresh = false, no_cache = false, quiet = false, latex = false, profile = false;
};

verify_options checked_options(const arguments& given) {
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
  return options;
}

std::vector<scene> checked_scenes(const arguments& given) {
  std::vector<scene> scenes;
  for (const auto& name : given.scenes) {
    auto loaded = load_scene(name);
    if (std::ranges::find(scenes, loaded.name, &scene::name) != scenes.end())
      throw input_error(fmt::format(
          "{}: name = '{}': another scene has it; accepted: names that differ, as each scene has its folder",
          one_line(name, 200), loaded.name));
    scenes.push_back(std::move(loaded));
  }
  return scenes;
}

/// "weak: 4 of 10 experiments after 12 s".
std::string told_of(const report::results& r) {
  const auto done = r.experiments.size();
  return fmt::format("{}: {} of {} experiments after {}", r.experiments.back().name, done, done + r.to_come.size(),
                     duration_text(r.provenance.wall_seconds));
}

void write_whole(const arguments& given, std::span<const report::results> all) {
  const defer_signals whole;
  report::write_report(given.out, all, given.latex ? report::latex::yes : report::latex::no);
}

/// The report grows: it is there after the first experiment, marked unfinished until the last.
std::vector<report::results> run_all(std::span<const scene> scenes, verify_options options, const arguments& given) {
  std::vector<report::results> all;
  const bool notes = given.progress == "lines" && !given.quiet;
  progress_line progress{!given.quiet && !notes};
  for (const auto& scene : scenes) {
    const auto label = [&](std::string_view what) {
      return scenes.size() == 1 ? std::string{what} : fmt::format("{}: {}", scene.name, what);
    };
    const auto sink = [&](double share, std::string_view what) {
      progress.show((static_cast<double>(all.size()) + share) / static_cast<double>(scenes.size()), label(what));
    };
    options.so_far = [&](const report::results& part) {
      all.push_back(part);
      write_whole(given, all);
      all.pop_back();
      if (notes) progress_note(label(told_of(part)));
    };
    all.push_back(verify(scene, options, sink));
    if (notes) progress_note(label(told_of(all.back())));
  }
  return all;
}

/// Null with --no-cache.
std::unique_ptr<report::result_folder> cache_for(const arguments& given, const std::filesystem::path& out) {
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

void print_all(const arguments& given, std::span<const report::results> all,
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

int run(const arguments& given) {
  format_option(given.format);
  choose("--progress", given.progress, std::array<std::string, 2>{"auto", "lines"});
  auto options = checked_options(given);
  const auto scenes = checked_scenes(given);
  for (const auto& scene : scenes) check_options(scene, options);
  if (given.out.empty()) throw input_error("--out '': accepted: the folder to be written");
  const std::filesystem::path out{given.out};
  report::check_output_folder(out);
  const baseline earlier(given.baseline, given.save_baseline, scenes);
  const auto cache = cache_for(given, out);
  options.store = cache.get();

  const auto all = run_all(scenes, options, given);
  const auto compared = earlier.compare(all);
  {
    const defer_signals whole;
    write_whole(given, all);
    earlier.save(all);
  }
  if (cache && !cache->trouble().empty())
    print_error(
        fmt::format("results are not kept for the next run: {}: {}", cache_folder().string(), cache->trouble()));
  print_all(given, all, compared);
  return worse_of(exit_code(all), exit_code(compared));
}

}  // namespace

command add_verify(CLI::App& app) {
  const auto given = std::make_shared<arguments>();
  given->scenes = {"paper"};
  given->threads = default_threads();
  auto& parser = add_command(app, "verify", "Hold the claims of the schemes against scenes");
  add_option(parser, "SCENE", given->scenes, "Built-in names or TOML files [paper]", "");
  add_option(parser, "--schemes", given->schemes, "Only these schemes", "A,B");
  add_option(parser, "--experiments", given->experiments, "Only these experiments", "X,Y");
  add_option(parser, "--effort", given->effort, "quick, standard, thorough [standard]", "E");
  add_option(parser, "--out", given->out, "Folder for the report [report]", "DIR");
  add_option(parser, "--threads", given->threads, "1 to 1024 [" + given->threads + "]", "N");
  add_option(parser, "--seed", given->seed, "Seed of the noise [1]", "N");
  add_option(parser, "--generator", given->generator, "Random bits: philox, ars [philox]", "NAME");
  add_option(parser, "--isa", given->isa, "Instruction set: auto, v2, v3, v4 [auto]", "NAME");
  add_option(parser, "--baseline", given->baseline, "Compare with what has this name", "NAME");
  add_option(parser, "--save-baseline", given->save_baseline, "Keep the results under this name", "NAME");
  add_option(parser, "--format", given->format, "On standard output: text, json [text]", "F");
  add_option(parser, "--progress", given->progress, "auto: on terminals; lines: one an experiment [auto]", "P");
  add_flag(parser, "--latex", given->latex, "Write report.tex, too: tables and plots for a paper");
  add_flag(parser, "--profile", given->profile, "Say where the processor time went");
  add_flag(parser, "--fresh", given->fresh, "Compute all anew and replace what is cached");
  add_flag(parser, "--no-cache", given->no_cache, "Neither use the cache nor write to it");
  add_flag(parser, "-q,--quiet", given->quiet, "No summary, no progress");
  return {&parser, [given] { return run(*given); }};
}

}  // namespace polhode::cli
