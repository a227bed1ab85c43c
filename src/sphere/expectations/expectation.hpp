// SPDX-License-Identifier: Apache-2.0
// Expectations without sampling: E[f(Pi_T)] = (exp(T L) f)(Pi_0), L the generator
// (sphere/harmonics/backward_operator.hpp). What a projection leaves out of L f proves a bar
// (sphere/galerkin/poisson.hpp).
#pragma once

#include <Eigen/Core>

#include "sphere/galerkin/reference_value.hpp"
#include "sphere/sphere_problem.hpp"

namespace polhode {

// wanted: the degree; 0 lets the program choose; any other is taken as it is, with two lower ones where they tell the
// uncertainty.

/// E[f(Pi_time)] from Pi_0 = start (of length radius), time >= 0, to an absolute tolerance. Without noise: f on the one
/// path there is.
reference_value expectation(const sphere_problem& problem, const sphere_function& f, const Eigen::Vector3d& start,
                            double time, double tolerance, int wanted = 0);

}  // namespace polhode
