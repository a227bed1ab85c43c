// SPDX-License-Identifier: Apache-2.0
// Squared errors of coupled levels, and their norms over the paths.
#pragma once

#include <cstddef>
#include <vector>

namespace polhode {

/// Squared errors of coupled levels: paths x levels, row by row.
struct squared_errors {
  int paths = 0, levels = 0;
  std::vector<double> values;
  double at(int path, int level) const { return values[static_cast<std::size_t>(path * levels + level)]; }
  double& at(int path, int level) { return values[static_cast<std::size_t>(path * levels + level)]; }
};

struct mean_and_error {
  double mean = 0, error = 0;  ///< with its standard error
};
mean_and_error level_mean(const squared_errors&, int level);

/// Norm of the errors in L^p, (mean |error|^p)^(1/p).
mean_and_error level_norm(const squared_errors&, double p, int level);

/// |error|^p of each.
squared_errors raised(const squared_errors&, double p);

}  // namespace polhode
