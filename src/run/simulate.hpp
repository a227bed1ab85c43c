// SPDX-License-Identifier: Apache-2.0
// An ensemble of bodies on a scene: checks what is asked, runs it, hands plain values back.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "ensemble/simulation.hpp"
#include "foreign/foreign_scheme.hpp"
#include "reports/model/simulation.hpp"
#include "run/checkpoint_store.hpp"
#include "run/progress_sink.hpp"
#include "run/ranks.hpp"
#include "scene/scene.hpp"

namespace polhode {

struct simulate_options {
  std::string scheme, noise, start;  ///< start empty: uniform, but where all start alike for independent noise
  double dt = 0;
  std::int64_t bodies = 0;
  std::vector<double> snapshots;  ///< times; each is moved to the nearest step
  double record_every = 0;        ///< time, a multiple of dt; 0: nothing is recorded
  record_sink record = {};        ///< is told of it, by several threads at once
  std::uint64_t seed = 1;
  int threads = 1;
  std::string isa = "auto", generator = "philox";  ///< as in verify_options
  std::string normals = "fast";                    ///< fast (float-accurate) or precise
  foreign::foreign_schemes foreign = {};           ///< integrators from elsewhere, beside ours
  bool final_states = true;                        ///< false: of each body at the end nothing is kept
  /// Where the run is saved on its way, and taken up from; null: nowhere. Not with records, nor with a foreign scheme.
  checkpoint_store* checkpoints = nullptr;
  const ranks* among =
      nullptr;             ///< processes that share the bodies; the first has the result. Nothing is recorded then
  double save_every = 10;  ///< seconds, and at least fifty times as long as a save takes
};

/// Throws input_error, before any work, on what cannot be run.
void check_simulation(const scene&, const simulate_options&);

/// What will be recorded, for who makes room for it.
struct recording_plan {
  std::int64_t bodies = 0, records = 0;
  std::vector<std::string> components;
  double dt = 0;  ///< from record to record
};
/// Throws as check_simulation.
recording_plan planned_recording(const scene&, const simulate_options&);

report::simulation simulate(const scene&, const simulate_options&, const progress_sink& = {});

}  // namespace polhode
