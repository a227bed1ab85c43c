// SPDX-License-Identifier: Apache-2.0
// A loop that is timed, and what the timings came to.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

namespace polhode::bench {

/// `advance` does `items` of `unit` (path_step, normal, flop) a call.
struct loop {
  double items;
  std::function<void()> advance;
  std::string unit = "path_step";
};

/// Registers a loop under that name; `make` is called before each repetition, outside the time.
void add(const std::string& name, const std::function<loop()>& make, bool all_threads = false);

/// Seconds an item, the least of the repetitions: CPU time of the thread (of all threads where it said so), and wall.
struct timing {
  double cpu, wall;
};

class timings {
 public:
  void take(const std::string& name, const timing&);
  std::optional<timing> of(const std::string& name) const;
  bool empty() const { return least_.empty(); }

 private:
  std::map<std::string, timing> least_;
};

/// Runs what was registered and the command line selects. Prints its table, on standard output, in the order of
/// registration. Empty where no loop ran or standard output is not for tables (--benchmark_format); nothing where the
/// command line selects nothing.
std::optional<timings> run_registered();

}  // namespace polhode::bench
