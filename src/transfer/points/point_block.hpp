// SPDX-License-Identifier: Apache-2.0
// Points in the layout of a kernel: blocks of lanes.
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "ensemble/kernel.hpp"

namespace polhode {

using points_in_space = Eigen::Matrix<double, Eigen::Dynamic, 3>;  ///< a point a row

inline int lanes_in_use(const points_in_space& points, int first) {
  return std::min(block_lanes, static_cast<int>(points.rows()) - first);
}

/// Points first, first + 1 ... to [component][lane]; beyond the last one that one again.
inline void load_block(const points_in_space& points, int first, double* to) {
  const int last = lanes_in_use(points, first) - 1;
  for (int i = 0; i < 3; ++i)
    for (int lane = 0; lane < block_lanes; ++lane) to[i * block_lanes + lane] = points(first + std::min(lane, last), i);
}

}  // namespace polhode
