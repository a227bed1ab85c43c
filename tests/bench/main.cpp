// SPDX-License-Identifier: Apache-2.0
// ns per path, step and core of every scheme, beside the peak of the core and what others write; see ci/bench --help.
// --check holds the yardsticks to what they stand beside, and measures nothing.
#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include <string_view>
#include <vector>

#include "bench/catalogue.hpp"
#include "bench/check.hpp"
#include "bench/measure.hpp"
#include "bench/summary.hpp"

namespace {

/// Short, many times and interleaved, so that a busy neighbour spoils some repetitions of each and not all of one. What
/// the command line says comes later and wins.
std::vector<char*> with_defaults(int argc, char** argv) {
  static char defaults[][48] = {"--benchmark_min_time=0.01", "--benchmark_repetitions=9",
                                "--benchmark_enable_random_interleaving=true"};
  std::vector<char*> all{argv[0]};
  for (char* option : defaults) all.push_back(option);
  all.insert(all.end(), argv + 1, argv + argc);
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace polhode::bench;
  if (argc == 2 && std::string_view(argv[1]) == "--check") return yardsticks_agree() ? 0 : 1;
  register_everything();
  auto arguments = with_defaults(argc, argv);
  int count = static_cast<int>(arguments.size());
  arguments.push_back(nullptr);
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
  fmt::print(stderr, "polhode_bench: every loop in several repetitions, interleaved; tables come at the end\n");
  const auto measured = run_registered();
  if (!measured) return 2;
  if (!measured->empty()) print_summary(*measured);
  benchmark::Shutdown();
}
