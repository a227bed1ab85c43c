// SPDX-License-Identifier: Apache-2.0
// An experiment asks one question of every scheme on a scene and answers in plain values.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <polhode/noise/address.hpp>
#include <string>
#include <utility>
#include <vector>

#include "problem/subject.hpp"
#include "reports/model/results.hpp"

namespace polhode {

enum class effort { quick, standard, thorough };

/// What an experiment runs on. `progress` takes the share of this experiment that is done, from one thread at a time.
struct context {
  const polhode::subject& subject;
  polhode::effort effort = effort::standard;
  int threads = 1;
  std::uint64_t seed = 1;
  noise_generator generator = noise_generator::philox;
  std::function<void(double share)> progress = [](double) {};
  const report::results* before = nullptr;  ///< what the experiments before this one found
};

/// What an experiment expects to do for each scheme, by what runs of it have done.
struct expected_work {
  double path_steps = 0;  ///< of single paths, or what takes as long
  double seconds = 0;     ///< of a processor beside them: operators and their equations
};

struct experiment {
  report::experiment info;
  std::function<expected_work(const subject&, effort)> work;
  /// Why this experiment cannot say anything about this scene; empty: it can.
  std::function<std::optional<std::string>(const subject&)> skip_reason;
  /// Appends measurements, fits, verdicts and skips.
  std::function<void(const context&, report::results&)> run;
  /// Names under which it reports what follows from a scheme's results, and that scheme: kept and computed with it.
  std::vector<std::pair<std::string, std::string>> derived = {};
  bool kept = true;  ///< false: never taken from an earlier run, as it times this machine or reads other experiments
};

experiment casimir_experiment();
experiment strong_experiment();
experiment energy_experiment();
experiment gibbs_experiment();
experiment attractor_experiment();
experiment lyapunov_experiment();
experiment weak_experiment();
experiment modified_experiment();
experiment stability_experiment();
experiment work_precision_experiment();

/// Why exact laws are missing.
inline constexpr const char* no_exact_law =
    "the exact law is computed on a sphere of momentum, and this system does not live on one";

/// By effort: quick, standard, thorough.
template <class T>
T by_effort(effort e, T quick, T standard, T thorough) {
  return e == effort::quick ? quick : e == effort::standard ? standard : thorough;
}

}  // namespace polhode
