// SPDX-License-Identifier: Apache-2.0
// Blocks of paths, their noise and their threads.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <polhode/noise/normal.hpp>

#include "ensemble/kernel.hpp"
#include "ensemble/lanes.hpp"
#include "ensemble/model.hpp"

namespace polhode {

/// Calls work(0) … work(count - 1) on that many threads, in any order; each writes to its own place, so that results do
/// not depend on the number of threads. Pieces are handed out one at a time. The first exception is passed on, and
/// between pieces the work can be stopped (platform/stopping.hpp).
void parallel_for(int threads, int count, const std::function<void(int)>& work);

/// Wiener increments of the paths first_path … first_path + block_lanes - 1, by address.
class increment_buffer {
 public:
  /// with_areas: areas of one step, drawn from a weak surrogate: independent normals of variance dt^2/4, which has the
  /// moments of the true areas that weak order two needs. For strong errors use model::coarsen instead.
  increment_buffer(const model&, int steps, bool with_areas, noise_source = {});

  /// Steps first_step … of size dt.
  increment_view fill(std::uint64_t seed, std::uint64_t first_path, std::uint64_t first_step, int steps, double dt);

 private:
  noise_layout layout_;
  noise_source source_;
  lane_vector<double> dw_;
  lane_vector<float> singles_;  // in place of dw_, where normals are fast: half the memory
  lane_vector<double> area_;
};

/// Every lane starts at this state.
std::vector<double> replicated(std::span<const double> state);

/// The state of one lane.
std::vector<double> lane_of(std::span<const double> states, int lane, int dimension);

}  // namespace polhode
