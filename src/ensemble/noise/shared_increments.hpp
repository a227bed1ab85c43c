// SPDX-License-Identifier: Apache-2.0
// One noise for many bodies: the increments of one path over all steps, computed once.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <polhode/noise/address.hpp>

#include "ensemble/kernel.hpp"
#include "ensemble/lanes.hpp"
#include "ensemble/model.hpp"

namespace polhode {

class shared_increments {
 public:
  /// The numbers that increment_buffer gives to the path, areas included.
  shared_increments(const model&, std::uint64_t seed, std::int64_t steps, double dt, bool with_areas, int threads,
                    noise_source = {}, std::uint64_t path = 0);

  /// Those of the paths first_path … first_path + block_lanes - 1, drawn side by side: the same numbers sooner.
  static std::vector<shared_increments> of_block(const model&, std::uint64_t seed, std::int64_t steps, double dt,
                                                 bool with_areas, noise_source, std::uint64_t first_path);

  /// Steps first_step … first_step + steps - 1.
  increment_view view(std::int64_t first_step, int steps) const;
  std::uint64_t drawn() const { return drawn_; }

  static double bytes(const model&, std::int64_t steps, bool with_areas);

 private:
  shared_increments(const model&, std::int64_t steps, bool with_areas);

  noise_layout layout_;
  std::uint64_t drawn_;
  std::vector<double> dw_, area_;
};

/// A block in which every path, of a number that divides block_lanes, drives as many neighbouring lanes.
class increments_side_by_side {
 public:
  explicit increments_side_by_side(std::span<const shared_increments> paths) : paths_(paths) {}

  /// Steps first_step … first_step + steps - 1; good until the next call.
  increment_view view(std::int64_t first_step, int steps);

 private:
  std::span<const shared_increments> paths_;
  lane_vector<double> dw_, area_;
};

}  // namespace polhode
