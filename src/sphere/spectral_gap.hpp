// SPDX-License-Identifier: Apache-2.0
// The slowest rate at which a diffusion on the sphere forgets (sphere/expectations/expectation.hpp).
#pragma once

#include "sphere/galerkin/reference_value.hpp"
#include "sphere/sphere_problem.hpp"

namespace polhode {

/// The slowest rate at which expectations relax, to an absolute tolerance and to a hundredth of itself. 0 where a
/// further function is conserved (then no law is unique). wanted: the degree; 0 lets the program choose.
reference_value spectral_gap(const sphere_problem& problem, double tolerance, int wanted = 0);

}  // namespace polhode
