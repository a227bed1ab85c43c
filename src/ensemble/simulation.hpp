// SPDX-License-Identifier: Apache-2.0
// An ensemble of bodies through time: one scheme, one system, stops at which the directions are counted.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <polhode/noise/address.hpp>

#include "ensemble/ensemble_progress.hpp"
#include "ensemble/kernel.hpp"
#include "ensemble/model.hpp"
#include "ensemble/observing/block_record.hpp"
#include "ensemble/observing/observation.hpp"

namespace polhode {

enum class ensemble_noise { common, independent, none };
/// uniform: on the sphere of the momentum; orbit: all over its coadjoint orbit (orbit_start.hpp); momentum: all there.
enum class ensemble_start { uniform, momentum, orbit };

struct simulation_plan {
  ensemble_noise noise = ensemble_noise::none;
  ensemble_start start = ensemble_start::momentum;
  std::vector<double> momentum;  ///< where all start, or a point of the sphere or orbit on which they do
  int pictured = 0;              ///< the first of the three components whose direction snapshots count
  std::int64_t steps = 0, bodies = 0;
  std::vector<std::int64_t> snapshots;  ///< step numbers, strictly increasing, in [1, steps]
  bool with_areas = false;
  noise_source source;
  std::uint64_t seed = 0;
  std::uint64_t path = 0;  ///< whose noise is common to all
  int threads = 1;
  std::function<void(const increment_view&)> hear = {};  ///< is told of a common noise before it is used
  std::int64_t record_every = 0;                         ///< steps; 0: nothing is recorded. The start is record 0
  record_sink record = {};                               ///< by several threads at once, each of other bodies
  bool keep_states = true;                               ///< false: of the states at the end only what is observed
  std::int64_t slice = 65'536;                           ///< steps between two words on progress, two chances to save
  std::function<void(ensemble_progress&)> resume = {};   ///< may set how far the run is; nothing is recorded then
  std::function<bool()> save_due = {};                   ///< asked often, by any thread
  std::function<void(const ensemble_progress&)> save = {};  ///< called by one thread while the others wait
  int rank = 0, ranks = 1;                                  ///< this process runs the pieces of its rank
  std::function<void(ensemble_progress&)> join = {};        ///< joins what the other ranks have done

  std::int64_t records() const { return record_every > 0 ? steps / record_every + 1 : 0; }
};

struct ensemble_snapshot : direction_counts {
  ensemble_moments moments;
};

struct simulated {
  std::vector<double> states;  ///< [component][body]
  ensemble_moments final;
  std::vector<ensemble_snapshot> snapshots;
  std::uint64_t drawn = 0;  ///< increments and areas computed for bodies that exist; starting points are not among them
};

/// Steps are the kernel's. `progress` is given the share done, one call at a time. The result is a function of the
/// kernel and of the plan without its threads.
simulated simulate_ensemble(const model&, const kernel&, const simulation_plan&,
                            const std::function<void(double)>& progress = {});

/// What simulate_ensemble will hold at once.
double simulation_bytes(const model&, const kernel&, const simulation_plan&);

}  // namespace polhode
