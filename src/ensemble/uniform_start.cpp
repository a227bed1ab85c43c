// SPDX-License-Identifier: Apache-2.0
#include "ensemble/uniform_start.hpp"

#include <cmath>

#include "ensemble/kernel.hpp"
#include "ensemble/noise/normal_block.hpp"

namespace polhode {

void start_uniformly(std::uint64_t seed, std::uint64_t first_body, double radius, std::span<double> states) {
  fill_normals({seed, noise_kind::initial_state, first_body, 0, 1, 3, 3, 1, states.data()});
  double *x = states.data(), *y = x + block_lanes, *z = y + block_lanes;
  for (int i = 0; i < block_lanes; ++i) {
    const double length = std::sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
    x[i] = radius * x[i] / length;
    y[i] = radius * y[i] / length;
    z[i] = radius * z[i] / length;
  }
}

std::vector<double> uniform_states(std::uint64_t seed, std::uint64_t first_body, double radius) {
  std::vector<double> states(3 * block_lanes);
  start_uniformly(seed, first_body, radius, states);
  return states;
}

}  // namespace polhode
