// SPDX-License-Identifier: Apache-2.0
// How far an ensemble is: what is kept of a run that may be interrupted, and what ranks hand to each other.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "ensemble/kernel.hpp"
#include "ensemble/observing/observation.hpp"

namespace polhode {

/// Some blocks of bodies, one after the other through the whole time.
struct piece_progress {
  std::int64_t block = 0, step = 0;       ///< blocks done, and steps of the one after them
  std::vector<double> states;             ///< of that block between two steps, the kernel's own; none at step 0
  std::vector<ensemble_moments> moments;  ///< at each snapshot and at the end, of what is done
};

struct direction_counts {
  std::vector<std::uint32_t> counts;   ///< longitude_bins
  std::vector<std::uint32_t> picture;  ///< hemisphere_bins
};

/// Bytes that are written or read; a source throws where they have run out.
using byte_sink = std::function<void(const void*, std::size_t)>;
using byte_source = std::function<void(void*, std::size_t)>;

struct ensemble_progress {
  std::int64_t bodies = 0, blocks_a_piece = 1;
  std::vector<double>
      states;  ///< [component][body] at the end, of blocks that are done; empty where nobody asks for them
  std::vector<piece_progress> pieces;
  std::vector<direction_counts> snapshots;

  std::int64_t blocks_of(std::size_t piece) const;
  /// Steps times blocks.
  double steps_done(std::int64_t steps_of_a_block) const;
  /// Takes over the pieces in which the other is further; of each piece one of the two has not begun.
  void join(const ensemble_progress& other);

  void write(const byte_sink&) const;
  /// Into one of the same run. Throws std::runtime_error on what is of another.
  void read(const byte_source&);
};

}  // namespace polhode
