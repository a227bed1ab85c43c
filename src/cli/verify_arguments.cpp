// SPDX-License-Identifier: Apache-2.0
#include "cli/verify_arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "cli/options/arguments.hpp"
#include "cli/options/opened_scene.hpp"
#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"
#include "reports/writers/folder.hpp"
#include "scene/nearest.hpp"

namespace polhode::cli {

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

}  // namespace polhode::cli
