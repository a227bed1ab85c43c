// SPDX-License-Identifier: Apache-2.0
// E[f(Pi_t)] for a polynomial f and a short time by the generator's own powers, in fifty digits.
//
//   E[f(Pi_t)] = sum_{k < n} t^k / k! L^k f + remainder,   |remainder| <= t^n / n! sup |L^n f|
//
// (the semigroup is a contraction), L acting on polynomials of x = Pi / c in three coordinates: exact, nothing is
// projected. The supremum is taken over a spiral of points, and doubled.
#pragma once

#include <optional>

#include "sphere/sphere_problem.hpp"

namespace polhode::test {

struct series_value {
  double value, remainder;
};

/// Of h; nothing where the terms leave a remainder above the tolerance.
std::optional<series_value> energy_by_series(const sphere_problem&, const Eigen::Vector3d& start, double time,
                                             double tolerance);

}  // namespace polhode::test
