// SPDX-License-Identifier: Apache-2.0
// polhode simulate: an ensemble of bodies, its final states, its snapshots and their pictures.
#include "run/simulate.hpp"

#include <fmt/format.h>

#include <limits>
#include <memory>

#include "cli/commands.hpp"
#include "cli/kept/cache.hpp"
#include "cli/kept/checkpoints.hpp"
#include "cli/options/arguments.hpp"
#include "cli/options/integrators.hpp"
#include "cli/terminal/progress.hpp"
#include "cli/terminal/signals.hpp"
#include "cli/terminal/terminal.hpp"
#include "cli/together.hpp"
#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"
#include "reports/writers/colour_map.hpp"
#include "reports/writers/numbers.hpp"
#include "reports/writers/recording_file.hpp"
#include "reports/writers/simulation_folder.hpp"
#include "reports/writers/simulation_json.hpp"
#include "scene/nearest.hpp"

namespace polhode::cli {
namespace {

constexpr std::uint64_t most_bodies = std::numeric_limits<std::uint32_t>::max();  // what a bin of a histogram can count

struct simulate_arguments {
  integrator_arguments integrators;
  std::string scene = "paper", scheme, dt, bodies, noise, start, snapshots, record;
  std::string out = "simulation", threads, seed = "1", isa = "auto", generator = "philox", normals = "fast",
              format = "text", colour_map = "viridis", histogram = "npy", recording, save_every = "10";
  bool quiet = false, no_final = false, fresh = false, no_cache = false;
};

const std::string& required(std::string_view option, const std::string& text) {
  if (text.empty())
    throw input_error(fmt::format("{} is missing; simulate needs --scheme, --dt, --bodies, --noise", option));
  return text;
}

simulate_options simulate_options_of(const simulate_arguments& given) {
  simulate_options options;
  options.scheme = required("--scheme", given.scheme);
  options.dt = positive_option("--dt", required("--dt", given.dt));
  options.bodies =
      static_cast<std::int64_t>(integer_option("--bodies", required("--bodies", given.bodies), 1, most_bodies));
  options.noise = required("--noise", given.noise);
  options.start = given.start;
  for (const auto& time : list_option("--snapshots", given.snapshots))
    options.snapshots.push_back(positive_option("--snapshots", time));
  if (!given.record.empty()) options.record_every = positive_option("--record", given.record);
  static const std::vector<std::string> kinds{"npy", "csv"};
  if (!given.recording.empty()) choose("--recording", given.recording, kinds);
  if (!given.recording.empty() && given.record.empty())
    throw input_error(fmt::format("--recording '{}': nothing is recorded; accepted with --record", given.recording));
  options.threads = threads_option(given.threads);
  options.seed = integer_option("--seed", given.seed, 0, std::numeric_limits<std::uint64_t>::max());
  options.isa = given.isa;
  options.foreign = opened_integrators(given.integrators);
  options.generator = given.generator;
  options.normals = given.normals;
  options.final_states = !given.no_final;
  options.save_every = positive_option("--checkpoint", given.save_every);
  return options;
}

report::snapshot_style checked_style(const simulate_arguments& given) {
  static const std::vector<std::string> histograms{"npy", "csv"};
  return {choose("--colour-map", given.colour_map, report::colour_map_names()),
          choose("--histogram", given.histogram, histograms) == 1};
}

std::string row(const report::ensemble_state& s) {
  auto out = fmt::format("{:>10} {:>8}", report::shown(s.time), s.lost);
  const auto add = [&](const report::mean_and_deviation& m) {
    out += fmt::format(" {:>10} {:>9}", report::shown(m.mean), report::shown(m.deviation));
  };
  add(s.energy);
  for (const auto& c : s.components) add(c);
  return out + '\n';
}

std::string shown_simulation(const report::simulation& s, const std::filesystem::path& out) {
  auto text =
      fmt::format("{} ({}): {}, dt = {}, {} steps, {} bodies, {} noise, {} start, seed {}\n\n", one_line(s.scene.name),
                  s.scene.system, s.scheme.name, s.dt, s.steps, s.bodies, s.noise, s.start, s.provenance.seed);
  text += fmt::format("{:>10} {:>8} {:>10} {:>9}", "time", "lost", "energy", "+-");
  for (std::size_t k = 0; k < s.final.components.size(); ++k)
    text += fmt::format(" {:>10} {:>9}", s.component(k), "+-");
  text += '\n';
  for (const auto& snapshot : s.snapshots)
    if (snapshot.state.step < s.steps) text += row(snapshot.state);
  text += row(s.final);
  text += fmt::format("\nlargest relative change of the Casimir: {}\n", report::shown(s.final.casimir_change));
  text += fmt::format("{:g} path-steps in {}: {:.3g} ns each; {} numbers drawn\n", s.path_steps,
                      report::shown_duration(s.provenance.wall_seconds), s.ns_per_path_step, s.numbers_drawn);
  if (s.resumed_at > 0)
    text += fmt::format("resumed at {:.1f} % from an interrupted run of the same; the time is that of the rest\n",
                        100 * s.resumed_at);
  for (const auto& remark : s.remarks) text += fmt::format("note: {}\n", remark);
  const auto written = s.states.empty() ? out : out / report::final_name(s);
  return text + fmt::format("{}: {}\n", s.states.empty() ? "written" : "final states", one_line(written.string()));
}

report::simulation run_it(const scene& s, const simulate_options& options, bool quiet) {
  progress_line progress{!quiet};
  return simulate(s, options, [&](double share, std::string_view what) { progress.show(share, what); });
}

/// The run, its states streamed into the folder.
report::simulation record_it(const scene& s, simulate_options options, const simulate_arguments& given, bool as_text,
                             const std::filesystem::path& folder) {
  const auto plan = planned_recording(s, options);
  const report::recording_file::shape shape{static_cast<std::uint64_t>(plan.bodies),
                                            static_cast<std::uint64_t>(plan.records), plan.components.size()};
  const std::filesystem::path out{given.out}, array = folder / report::recorded_npy;
  report::recording_file file(array, shape, out / report::recorded_npy);
  options.record = [&](const recorded_bodies& b) {
    const auto each = static_cast<std::size_t>(b.records) * shape.components;
    for (int i = 0; i < b.bodies; ++i)
      file.write(static_cast<std::uint64_t>(b.first_body + i), static_cast<std::uint64_t>(b.first_record),
                 std::span(b.values).subspan(static_cast<std::size_t>(i) * each, each));
  };
  auto result = run_it(s, options, given.quiet);
  file.close();
  if (as_text) {
    report::write_recording_csv(array, shape, plan.dt, plan.components, folder / report::recorded_csv,
                                out / report::recorded_csv);
    std::filesystem::remove(array);
  }
  return result;
}

report::simulation recorded(const scene& s, const simulate_options& options, const simulate_arguments& given,
                            const report::snapshot_style& style) {
  const bool as_text = given.recording == "csv";
  auto result = report::write_simulation(
      given.out, [&](const std::filesystem::path& folder) { return record_it(s, options, given, as_text, folder); },
      style);
  say_when_stopped("");
  return result;
}

report::simulation whole(const scene& s, const simulate_options& options, const simulate_arguments& given,
                         const report::snapshot_style& style) {
  auto result = run_it(s, options, given.quiet);
  const defer_signals until_written;
  report::write_simulation(given.out, result, style);
  say_when_stopped("");
  return result;
}

/// Null where nothing is kept between runs.
std::unique_ptr<checkpoint_folder> checkpoints_for(const simulate_arguments& given, const std::filesystem::path& out) {
  const auto folder = given.no_cache ? std::filesystem::path() : cache_beside(out);
  if (folder.empty()) return nullptr;
  using access = checkpoint_folder::access;
  return std::make_unique<checkpoint_folder>(
      folder, given.fresh ? access::rewrite : access::use, [quiet = given.quiet] {
        if (!quiet) say_when_stopped("stopped: the same command goes on from the last checkpoint");
      });
}

int run_simulate(const simulate_arguments& given) {
  const auto output = format_option(given.format);
  auto options = simulate_options_of(given);
  const auto style = checked_style(given);
  const auto scene = opened_scene(given.scene);
  options.among = others();
  check_simulation(scene, options);
  if (given.out.empty()) throw input_error("--out '': accepted: the folder to be written");
  const std::filesystem::path out{given.out};
  if (speaks()) report::check_simulation_folder(out);
  const auto checkpoints = checkpoints_for(given, out);
  options.checkpoints = checkpoints.get();
  if (!given.quiet) say_when_stopped("stopped before any checkpoint: nothing is written");

  if (!speaks()) {
    simulate(scene, options);
    if (checkpoints) checkpoints->forget();
    return 0;
  }
  const auto result =
      options.record_every > 0 ? recorded(scene, options, given, style) : whole(scene, options, given, style);
  if (checkpoints) {
    checkpoints->forget();
    if (!checkpoints->trouble().empty())
      print_error(fmt::format("no checkpoint of this run was kept: {}: {}", cache_beside(out).string(),
                              checkpoints->trouble()));
  }
  if (output == format::json)
    print(report::to_json(result));
  else if (!given.quiet)
    print(shown_simulation(result, out));
  return 0;
}

void add_common(CLI::App& parser, simulate_arguments& given) {
  add_option(parser, "--out", given.out, "Folder for the files [simulation]", "DIR");
  add_option(parser, "--threads", given.threads, "1 to 1024 [" + given.threads + "]", "N");
  add_option(parser, "--seed", given.seed, "Seed of the noise [1]", "N");
  add_option(parser, "--isa", given.isa, "Instruction set: auto, v2, v3, v4 [auto]", "NAME");
  add_option(parser, "--generator", given.generator, "Random bits: philox, ars [philox]", "NAME");
  add_option(parser, "--normals", given.normals, "fast (to 1e-6), precise [fast]", "K");
  add_option(parser, "--checkpoint", given.save_every, "Seconds from save to save of the run [10]", "S");
  add_option(parser, "--format", given.format, "On standard output: text, json [text]", "F");
  add_flag(parser, "--no-final", given.no_final, "Neither keep nor write the bodies' last states");
  add_flag(parser, "--fresh", given.fresh, "Do not go on from a checkpoint of an interrupted run");
  add_flag(parser, "--no-cache", given.no_cache, "Keep no checkpoint, and do not go on from one");
  add_flag(parser, "-q,--quiet", given.quiet, "No summary, no progress");
}

}  // namespace

command add_simulate(CLI::App& app) {
  const auto given = std::make_shared<simulate_arguments>();
  given->threads = default_threads();
  auto& parser = add_command(app, "simulate", "Run an ensemble of bodies; final states and pictures");
  add_option(parser, "SCENE", given->scene, "A built-in name or a TOML file [paper]", "");
  add_integrators(parser, given->integrators);
  add_option(parser, "--scheme", given->scheme, "The scheme; see polhode list schemes", "S");
  add_option(parser, "--dt", given->dt, "Step size; the horizon is a multiple", "H");
  add_option(parser, "--bodies", given->bodies, "How many", "N");
  add_option(parser, "--noise", given->noise, "common, independent, none", "K");
  add_option(parser, "--snapshots", given->snapshots, "Times to count and picture", "T1,T2");
  add_option(parser, "--colour-map", given->colour_map, "viridis, magma, cividis [viridis]", "NAME");
  add_option(parser, "--histogram", given->histogram, "Of a snapshot: npy, csv [npy]", "K");
  add_option(parser, "--record", given->record, "Time from record to record of every state", "EVERY");
  add_option(parser, "--recording", given->recording, "Of the records: npy, csv [npy]", "K");
  add_option(parser, "--start", given->start, "uniform, momentum, orbit [by the noise]", "K");
  add_common(parser, *given);
  return {&parser, [given] { return run_simulate(*given); }, true};
}

}  // namespace polhode::cli
