// SPDX-License-Identifier: Apache-2.0
// One step of a scheme from many points, through every node of the noise's rule.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <span>
#include <vector>

#include "transfer/points/noise_nodes.hpp"
#include "transfer/points/point_block.hpp"

namespace polhode {

/// Calls use(first point, lanes in use, nodes, states of these nodes [node][component][lane]) for all points and nodes.
template <class Use>
void map_points(const kernel& k, const points_in_space& points, const noise_nodes& noise, const Use& use) {
  constexpr int chunk = 32, block = 3 * block_lanes;
  const auto table = k.share(noise.path());
  const int nodes = static_cast<int>(noise.weight.size()), count = static_cast<int>(points.rows());
  std::vector<double> start(block), mapped(static_cast<std::size_t>(block) * chunk);
  for (int first = 0; first < count; first += block_lanes) {
    load_block(points, first, start.data());
    for (int node = 0; node < nodes; node += chunk) {
      const int n = std::min(chunk, nodes - node);
      for (int i = 0; i < n; ++i) {
        const std::span state(mapped.data() + i * block, block);
        std::ranges::copy(start, state.begin());
        k.advance(state, table, node + i, 1);
      }
      use(first, lanes_in_use(points, first),
          std::span(noise.weight).subspan(static_cast<std::size_t>(node), static_cast<std::size_t>(n)), mapped.data());
    }
  }
}

/// Calls use(point, weight, Pi after a step) for every point and node.
template <class Use>
void map_each_point(const kernel& k, const points_in_space& points, const noise_nodes& noise, const Use& use) {
  map_points(k, points, noise, [&](int first, int lanes, std::span<const double> weights, const double* states) {
    for (std::size_t i = 0; i < weights.size(); ++i)
      for (int lane = 0; lane < lanes; ++lane) {
        const double* at = states + 3 * block_lanes * static_cast<int>(i) + lane;
        use(first + lane, weights[i], Eigen::Vector3d(at[0], at[block_lanes], at[2 * block_lanes]));
      }
  });
}

}  // namespace polhode
