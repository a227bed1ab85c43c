// SPDX-License-Identifier: Apache-2.0
// Levels in double logarithms, from coarse to fine, and the weighted least-squares line through them.
#pragma once

#include <span>

namespace polhode {

struct log_level {
  int index;           ///< among all levels
  double x, y, error;  ///< logarithms of abscissa and value, the latter's standard error; 0: none, all weigh alike
  double weight() const { return error > 0 ? 1 / (error * error) : 1; }
};

struct log_line {
  double intercept = 0, slope = 0;
  double at(double x) const { return intercept + slope * x; }
};

log_line line_through(std::span<const log_level>);

/// How far the first level, the coarsest, lies off the line through the others.
double off_the_others(std::span<const log_level>);

/// Between the last two levels.
double slope_at_the_finest(std::span<const log_level>);

/// Of Student's 95 % interval of the slope, from the scatter about the line, all levels weighing the same.
double half_width_of_scatter(std::span<const log_level>, const log_line&);

}  // namespace polhode
