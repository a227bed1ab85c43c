// SPDX-License-Identifier: Apache-2.0
#include "bench/measure.hpp"

#include <benchmark/benchmark.h>
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <tuple>
#include <vector>

#include "platform/denormals.hpp"

namespace polhode::bench {
namespace {

using run_list = std::vector<benchmark::BenchmarkReporter::Run>;

std::map<std::string, double>& items_of() {
  static std::map<std::string, double> items;
  return items;
}

/// On a terminal: what is being measured.
void tell(const std::string& name) {
  static const bool terminal = isatty(STDERR_FILENO) != 0;
  if (terminal) fmt::print(stderr, "\r\033[K{}", name);
}

void time_loop(benchmark::State& state, const std::string& name, const std::function<loop()>& make) {
  using clock = std::chrono::steady_clock;
  tell(name);
  const flush_denormals flushed;
  const loop timed = make();
  timed.advance();
  const auto start = clock::now();
  for (auto _ : state) timed.advance();
  const double wall = std::chrono::duration<double>(clock::now() - start).count();
  using counter = benchmark::Counter;
  state.counters["per_" + timed.unit] = counter(timed.items, counter::kIsIterationInvariantRate | counter::kInvert);
  state.counters["wall_per_" + timed.unit] = wall / (timed.items * static_cast<double>(state.iterations()));
  items_of()[name] = timed.items;
}

/// Keeps the runs, which come in random order, and shows them in the order of registration; on a table one row a loop,
/// the least of its repetitions.
class collector : public benchmark::BenchmarkReporter {
 public:
  explicit collector(benchmark::BenchmarkReporter& shown)
      : shown_(shown), table_(dynamic_cast<benchmark::ConsoleReporter*>(&shown) != nullptr) {}

  bool ReportContext(const Context& context) override { return shown_.ReportContext(context); }
  void ReportRuns(const run_list& runs) override {
    runs_.push_back(runs);
    for (const auto& run : runs)
      if (run.run_type == Run::RT_Iteration && !run.error_occurred && run.iterations > 0) take(run);
  }
  void Finalize() override {
    tell("");
    const auto place = [](const run_list& runs) {
      return std::tuple(runs.front().family_index, runs.front().per_family_instance_index);
    };
    std::ranges::stable_sort(runs_, {}, place);
    for (const auto& runs : runs_)
      if (const auto rows = table_ ? least(runs) : runs; !rows.empty()) shown_.ReportRuns(rows);
    shown_.Finalize();
  }
  bool table() const { return table_; }
  const timings& taken() const { return taken_; }

 private:
  void take(const Run& run) {
    const auto& name = run.run_name.function_name;
    const double items = items_of().at(name) * static_cast<double>(run.iterations);
    taken_.take(name, {run.cpu_accumulated_time / items, run.real_accumulated_time / items});
  }
  static run_list least(const run_list& runs) {
    run_list kept;
    std::ranges::copy_if(runs, std::back_inserter(kept), [](const Run& run) {
      return run.error_occurred || run.repetitions <= 1 || run.aggregate_name == "min";
    });
    return kept;
  }

  benchmark::BenchmarkReporter& shown_;
  bool table_;
  timings taken_;
  std::vector<run_list> runs_;
};

}  // namespace

void add(const std::string& name, const std::function<loop()>& make, bool all_threads) {
  auto* added = benchmark::RegisterBenchmark(name.c_str(),
                                             [name, make](benchmark::State& state) { time_loop(state, name, make); });
  added->ComputeStatistics("min", [](const std::vector<double>& v) { return *std::ranges::min_element(v); });
  if (all_threads) added->MeasureProcessCPUTime()->UseRealTime();
}

void timings::take(const std::string& name, const timing& t) {
  const auto [at, first] = least_.try_emplace(name, t);
  at->second = {std::min(at->second.cpu, t.cpu), std::min(at->second.wall, t.wall)};
}

std::optional<timing> timings::of(const std::string& name) const {
  const auto at = least_.find(name);
  return at == least_.end() ? std::nullopt : std::optional(at->second);
}

std::optional<timings> run_registered() {
  const std::unique_ptr<benchmark::BenchmarkReporter> shown(benchmark::CreateDefaultDisplayReporter());
  collector collected(*shown);
  if (benchmark::RunSpecifiedBenchmarks(&collected) == 0) return std::nullopt;
  return collected.table() ? collected.taken() : timings{};
}

}  // namespace polhode::bench
