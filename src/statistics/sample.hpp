// SPDX-License-Identifier: Apache-2.0
// Means and distributions of independent samples.
#pragma once

#include <functional>
#include <span>

namespace polhode {

struct interval_estimate {
  double value = 0, low = 0, high = 0;
};

/// Mean of independent, identically distributed values with Student's 95 % interval. At least two values.
interval_estimate mean_interval(std::span<const double> values);

/// Kolmogorov-Smirnov distance sup |F_n - F| of independent values, with the 95 % interval that the
/// Dvoretzky-Kiefer-Wolfowitz inequality (Massart's constant, Ann. Probab. 18 (1990) 1269-1283) gives for the distance
/// of the law sampled: [D - e, D + e], e = sqrt(ln(2/0.05) / 2n). Of values that are not quite independent n is the
/// number of independent ones that they are worth; 0: all of them.
interval_estimate ks_distance(std::span<const double> values, const std::function<double(double)>& cdf,
                              double worth = 0);

}  // namespace polhode
