// SPDX-License-Identifier: Apache-2.0
#include "experiments/weak/twin_chain.hpp"

#include <algorithm>

#include "ensemble/noise/paths.hpp"

namespace polhode {
namespace {

/// E[f(Y_L)] - E[f] = older E[f(Y_L-1) - f(Y_L)] + last E[f(Y_L) - f(X)], up to the third order in dt, where the steps
/// of L - 1, L and X are 2 dt, dt and dt / cells: the powers dt and dt^2 come out right.
struct tail_weights {
  double older, last;
};
constexpr tail_weights weights_for(int cells) {
  const double r = 1.0 / cells, last = 2 / (3 * (1 - r) - (1 - r * r));
  return {1 - last * (1 - r), last};
}

template <class Real>
void turn_round(std::span<const Real> from, std::size_t row, int group, lane_vector<Real>& to) {
  to.resize(from.size());
  const auto size = static_cast<std::size_t>(group);
  for (std::size_t i = 0; i < from.size() / row; ++i) {
    const std::size_t first = i / size * size, source = first + (size - 1 - i % size);
    std::ranges::copy(from.subspan(source * row, row), to.begin() + static_cast<std::ptrdiff_t>(i * row));
  }
}

}  // namespace

twin_chain::twin_chain(const subject& s, const level_grid& grid, int cells, const driven_kernels& kernels)
    : channels_(static_cast<std::size_t>(s.model->layout().channels)),
      dimension_(s.model->dimension()),
      cells_(cells),
      kernels_(kernels),
      states_(grid.steps.size(), replicated(s.scene.momentum)) {}

void twin_chain::advance(const driven_block& truth) {
  for (std::size_t l = 0; l + 1 < states_.size(); ++l)
    kernels_.twins[l + 1]->advance(states_[l], opposite(truth.increments(l + 1), 2));
  kernels_.truth->advance(states_.back(), opposite(truth.fine(), cells_));
}

increment_view twin_chain::opposite(const increment_view& v, int group) {
  const std::size_t row = channels_ * block_lanes;
  turn_round(v.dw, row, group, dw_);
  turn_round(v.singles, row, group, singles_);
  return {v.steps, dw_, {}, singles_, v.scale};
}

std::vector<double> twin_chain::excess(const state_function& f, const driven_block& truth, int lane) const {
  const auto value = [&](const std::vector<double>& states) { return f(lane_of(states, lane, dimension_)); };
  const std::size_t levels = states_.size();
  std::vector<double> link(levels);
  double here = value(truth.twin(0));
  for (std::size_t l = 0; l < levels; ++l) {
    const double next = value(l + 1 < levels ? truth.twin(l + 1) : truth.truth());
    link[l] = here - (next + value(states_[l])) / 2;
    here = next;
  }
  const auto [older, last] = weights_for(cells_);
  std::vector<double> out(levels + 1);
  out[levels - 1] = older * link[levels - 2] + last * link[levels - 1];
  out[levels] = out[levels - 1] - link[levels - 1];
  for (std::size_t l = levels - 1; l-- > 0;) out[l] = out[l + 1] + link[l];
  return out;
}

}  // namespace polhode
