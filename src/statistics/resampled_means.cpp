// SPDX-License-Identifier: Apache-2.0
#include "statistics/resampled_means.hpp"

#include "statistics/resample.hpp"

namespace polhode {

// How often each path is drawn is a matrix, so that all columns, of one quantity or of several, are one product.
Eigen::MatrixXd resampled_means(const values_of_paths& values, std::uint64_t seed) {
  const auto paths = static_cast<int>(values.rows());
  values_of_paths drawn = values_of_paths::Zero(bootstrap_replicates, paths);
  for (int r = 0; r < bootstrap_replicates; ++r)
    for (const int path : resample(seed, r, paths)) drawn(r, path) += 1;
  return drawn * values / paths;
}

}  // namespace polhode
