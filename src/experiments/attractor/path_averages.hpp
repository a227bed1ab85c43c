// SPDX-License-Identifier: Apache-2.0
// What averages over 1, 2, 4, … noise paths are off by.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "statistics/orders/order_fit.hpp"

namespace polhode {

/// The mean over all rows of paths and how far it may be off, 95 % (rows resampled).
struct grand_mean {
  Eigen::VectorXd value;
  double error = 0;
};

/// means: [coefficient][path], whole rows of paths.
grand_mean mean_of(const Eigen::MatrixXd& means, std::uint64_t seed);

/// Root-mean-square distance after averaging N = 1, 2, 4, … paths, and what it is fitted to.
struct distances {
  std::vector<double> paths, value;
  std::vector<std::optional<double>> low, high;
  squared_errors rows;  ///< less the bias, for N up to a row
};

/// means: [coefficient][block, look, path of the block]. Intervals are over paths: looks at one path are not
/// independent of each other, as bodies that have met stay together for long.
distances distances_of(const Eigen::MatrixXd& means, int looks, double bias);

/// The slope over N: that over 1/N with the other sign.
std::optional<order_fit> slope_over_paths(const distances&, std::uint64_t seed);

}  // namespace polhode
