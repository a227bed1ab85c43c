// SPDX-License-Identifier: Apache-2.0
// Means of coupled levels over resampled paths.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "statistics/orders/squared_errors.hpp"

namespace polhode {

/// A path a row.
using values_of_paths = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

inline auto matrix_of(const squared_errors& e) {
  return Eigen::Map<const values_of_paths>(e.values.data(), e.paths, e.levels);
}

/// [replicate][column] of [path][column], bootstrap_replicates of them; a pure function of values and seed. A path is
/// drawn with all its columns, so that they stay coupled.
Eigen::MatrixXd resampled_means(const values_of_paths&, std::uint64_t seed);

}  // namespace polhode
