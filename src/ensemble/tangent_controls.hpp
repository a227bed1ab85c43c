// SPDX-License-Identifier: Apache-2.0
// Sums that control variates of the growth of tangents are made of, compiled once per instruction set.
#pragma once

#include <array>

#include "ensemble/kernel.hpp"
#include "platform/isa_entry.hpp"

namespace polhode {

inline constexpr int tangent_control_count = 48;

/// Of a block of bodies before one step: adds the controls of experiments/lyapunov/tangent_runs.hpp to sums,
/// [control][lane].
struct tangent_controls {
  const double *states, *tangents;  ///< [component][lane]; of two tangents the first counts
  increment_view step;              ///< one, of dt
  double dt;
  std::array<double, 9> sigma;       ///< [component][channel]: B = sigma dW
  std::array<double, 9> covariance;  ///< Q = sigma sigma^T, by rows
  double* sums;
};

/// By the instruction set in force.
void add_tangent_controls(const tangent_controls&);

}  // namespace polhode

POLHODE_DECLARE_ENTRIES(polhode_add_controls_, const polhode::tangent_controls&);
