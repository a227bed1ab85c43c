// SPDX-License-Identifier: Apache-2.0
// What an expectation is without noise: the observable on the one path there is.
#pragma once

#include "sphere/galerkin/reference_value.hpp"
#include "sphere/sphere_problem.hpp"

namespace polhode {

/// f(Pi_time), by Boost.Odeint; the uncertainty is its distance from a second way: Jacobi's functions where there is no
/// dissipation, else the same in two pieces. No value where the time holds too many turns.
reference_value on_the_path(const sphere_problem& problem, const sphere_function& f, const Eigen::Vector3d& start,
                            double time);

}  // namespace polhode
