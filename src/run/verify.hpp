// SPDX-License-Identifier: Apache-2.0
// The main job: every scheme x every experiment that applies to a scene.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "experiments/common/experiment.hpp"
#include "foreign/foreign_scheme.hpp"
#include "reports/model/result_store.hpp"
#include "reports/model/results.hpp"
#include "run/bind_scene.hpp"
#include "run/progress_sink.hpp"
#include "run/ranks.hpp"
#include "run/time_budget.hpp"
#include "scene/scene.hpp"

namespace polhode {

/// Of one experiment, beforehand.
struct expected_cost {
  std::string experiment;
  double cpu_seconds = 0;
};

struct verify_options {
  std::vector<std::string> schemes;      ///< empty: all
  std::vector<std::string> experiments;  ///< empty: all
  polhode::effort effort = effort::standard;
  int threads = 1;
  std::uint64_t seed = 1;
  std::string generator = "philox";  ///< of random bits: philox, or ars where the processor has AES
  std::string isa = "auto";          ///< instruction set of the inner loops; auto: the widest that this machine has
  /// Called before the first experiment with what each is expected to cost.
  std::function<void(const std::vector<expected_cost>&)> beforehand = {};
  /// Called after every experiment but the last with what there is by then, the rest named in `to_come`.
  std::function<void(const report::results&)> so_far = {};
  bool profile = false;                   ///< say where the processor time went
  report::result_store* store = nullptr;  ///< keeps results from run to run; for schemes that are ours only
  foreign::foreign_schemes foreign = {};  ///< integrators from elsewhere, beside ours
  const ranks* among = nullptr;           ///< processes that share the work; null: this one alone
  std::shared_ptr<const time_budget> budget =
      nullptr;  ///< what it ends is named in `skipped`; null: as long as it takes
};

/// Runs the experiments. `provenance` of the result holds what is known here (seed, effort, threads, times).
/// Throws input_error on an unknown scheme or experiment (names the nearest one).
report::results verify(const scene&, const verify_options&, const progress_sink& = {});

/// What each experiment is expected to cost (run/forecast.hpp). Runs none; throws as verify() does.
std::vector<expected_cost> expected_costs(const scene&, const verify_options&);

/// Throws what verify() would throw of these options, before any work.
void check_options(const scene&, const verify_options&);

/// The same on a subject that is bound already: how tests bring a planted defect or a system of their own.
report::results verify_subject(subject, const verify_options&, const progress_sink& = {});

/// What `polhode list` prints.
std::vector<report::experiment> list_experiments();

}  // namespace polhode
