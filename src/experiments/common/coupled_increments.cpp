// SPDX-License-Identifier: Apache-2.0
#include "experiments/common/coupled_increments.hpp"

#include "ensemble/noise/noise_defect.hpp"

namespace polhode {

coupled_increments::coupled_increments(const model& m, const level_grid& grid, int cells, noise_source source)
    : model_(m),
      cells_(cells),
      levels_(grid.steps.size()),
      fine_(m, grid.steps.back() / grid.steps.front() * cells, false, source) {
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    const int steps = grid.steps[l] / grid.steps.front();
    levels_[l].dt = grid.horizon / grid.steps[l];
    levels_[l].dw.resize(m.layout().increments(steps, block_lanes));
    levels_[l].area.resize(m.layout().areas(steps, block_lanes));
    levels_[l].view = {steps, levels_[l].dw, levels_[l].area};
  }
}

increment_view coupled_increments::fill(std::uint64_t seed, std::uint64_t first_path, int chunk) {
  const int steps = levels_.back().view.steps * cells_;
  const auto first_step = static_cast<std::uint64_t>(chunk) * static_cast<std::uint64_t>(steps);
  const auto fine = fine_.fill(seed, first_path, first_step, steps, levels_.back().dt / cells_);
  model_.coarsen(fine, cells_, levels_.back().dw, levels_.back().area);
  for (std::size_t l = levels_.size() - 1; l-- > 0;)
    model_.coarsen(levels_[l + 1].view, 2, levels_[l].dw, levels_[l].area);
  if (const auto* defect = noise_defect_in_force())
    for (auto& level : levels_) {
      const auto& v = level.view;
      const auto first = static_cast<std::uint64_t>(chunk) * static_cast<std::uint64_t>(v.steps);
      defect->spoil(
          {first_path, first, block_lanes, v.steps, model_.layout(), level.dt, level.dw, {}, level.area, true});
    }
  return fine;
}

}  // namespace polhode
