// SPDX-License-Identifier: Apache-2.0
// Work that a run did, left out, or took from an earlier one: plain values.
#pragma once

#include <cstdint>
#include <string>

namespace polhode::report {

/// Work of the inner loops.
struct counters {
  std::uint64_t normals_drawn = 0;  ///< standard normals, for increments and areas
  std::uint64_t path_steps = 0;     ///< steps, each path counted
  std::uint64_t kernels_run = 0;    ///< calls of a kernel
  bool operator==(const counters&) const = default;
};

/// Work that was not done, as far as it is known.
struct saved {
  counters work;
  double cpu_seconds = 0;
};

/// Processor time of an experiment by what was worked on: a scheme, "noise", or empty for all else.
struct profile_row {
  std::string experiment, scheme;
  double cpu_seconds = 0;
};

/// Something that does not apply to a scene, or that a scheme does not claim. An empty scheme means all of them.
struct skip {
  std::string experiment, scheme, reason;
  report::saved saved = {};
};

/// Something inside an experiment that this scene does not need: what, why, and what leaving it out saved.
struct saving {
  std::string experiment, scheme, what, reason;
  report::saved saved;
};

/// What an experiment says of a scheme, taken from an earlier run on the same inputs by the same build.
struct reuse {
  std::string experiment, scheme;
  std::string computed;  ///< UTC, ISO 8601
  report::saved saved;   ///< its share of the run that computed it
};

/// What this run did itself. A result is what one experiment says of one scheme.
struct work_done {
  counters work;
  std::uint64_t experiments_run = 0, results_computed = 0, results_reused = 0;
};

}  // namespace polhode::report
