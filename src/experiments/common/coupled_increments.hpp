// SPDX-License-Identifier: Apache-2.0
// One noise for all step sizes: fine increments, and what Chen's relation makes of them on coarser levels.
#pragma once

#include <cstdint>
#include <vector>

#include "ensemble/model.hpp"
#include "ensemble/noise/paths.hpp"
#include "experiments/common/levels.hpp"

namespace polhode {

/// Increments and Levy areas of every level for a block of paths, a step of the coarsest level at a time. Nothing is
/// redrawn between levels. Areas come from the cells inside a step: with one cell the finest level has none.
class coupled_increments {
 public:
  /// Each of the grid's levels halves the step of the one before. cells: fine increments in the finest step.
  coupled_increments(const model&, const level_grid&, int cells, noise_source);

  /// The chunk-th step of the coarsest level; returns the fine increments.
  increment_view fill(std::uint64_t seed, std::uint64_t first_path, int chunk);

  /// Coarsest first; valid until the next fill.
  const increment_view& level(std::size_t l) const { return levels_[l].view; }

 private:
  struct level_increments {
    double dt = 0;
    std::vector<double> dw, area;
    increment_view view;
  };
  const model& model_;
  int cells_;
  std::vector<level_increments> levels_;
  increment_buffer fine_;
};

}  // namespace polhode
