// SPDX-License-Identifier: Apache-2.0
#include "ensemble/observing/observation.hpp"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

bool all_finite(std::span<const double> states, int lane) {
  for (auto at = static_cast<std::size_t>(lane); at < states.size(); at += block_lanes)
    if (!std::isfinite(states[at])) return false;
  return true;
}

}  // namespace

void ensemble_moments::merge(const ensemble_moments& other) {
  energy.merge(other.energy);
  for (std::size_t k = 0; k < components.size(); ++k) components[k].merge(other.components[k]);
  lost += other.lost;
  casimir_change = std::max(casimir_change, other.casimir_change);
}

ensemble_observer::ensemble_observer(const model& m, std::span<const double> momentum)
    : model_(m),
      start_casimirs_(m.casimirs(momentum)),
      energies_(block_lanes),
      casimirs_(start_casimirs_.size() * block_lanes) {
  for (const double c : start_casimirs_) casimir_scale_ = std::max(casimir_scale_, std::abs(c));
}

ensemble_moments ensemble_observer::nothing(const model& m) {
  return {{}, std::vector<running_moments>(static_cast<std::size_t>(m.dimension())), 0, 0};
}

running_moments ensemble_observer::moments_of(const double* row) {
  values_.clear();
  for (const int lane : found_) values_.push_back(row[lane]);
  return running_moments::of(values_);
}

void ensemble_observer::observe(std::span<const double> states, int lanes, ensemble_moments& out) {
  found_.clear();
  for (int lane = 0; lane < lanes; ++lane)
    if (all_finite(states, lane)) found_.push_back(lane);
  out.lost += lanes - static_cast<int>(found_.size());
  model_.conserved(states, energies_, casimirs_);
  out.energy.merge(moments_of(energies_.data()));
  for (std::size_t k = 0; k < out.components.size(); ++k)
    out.components[k].merge(moments_of(states.data() + k * block_lanes));
  double change = 0;
  for (std::size_t k = 0; k < start_casimirs_.size(); ++k)
    for (const int lane : found_)
      change =
          std::max(change, std::abs(casimirs_[k * block_lanes + static_cast<std::size_t>(lane)] - start_casimirs_[k]));
  out.casimir_change = std::max(out.casimir_change, change / casimir_scale_);
}

}  // namespace polhode
