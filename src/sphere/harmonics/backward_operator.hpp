// SPDX-License-Identifier: Apache-2.0
// A diffusion on the momentum sphere as linear algebra: its generator. With x = Pi / c, c the radius, in spherical
// harmonics up to a degree:
//
//   L = -sum_i M[a_i] L_i + 1/2 sum_jk Q_jk L_j L_k,   a = Omega + damping Pi x Omega,   Q = covariance,
//   E[f(Pi_T)] = (exp(T L) f)(Pi_0),   L^T rho = 0,   gap = least |Re lambda| besides the constant's 0.
//
// L_i = (x cross grad)_i. A Galerkin projection of degree L leaves a remainder in degrees L + 1 and L + 2, known
// exactly. The semigroup is a contraction in the supremum norm, so the remainder proves a bar for expectations and
// stationary means (sphere/galerkin/poisson.hpp). Density (sphere/stationary.hpp) and gap (sphere/spectral_gap.hpp):
// three successive degrees agree, the last of them high enough for the width of the noise
// (sphere/galerkin/raise_degree.hpp).
#pragma once

#include "sphere/harmonics/harmonics.hpp"
#include "sphere/sphere_problem.hpp"

namespace polhode {

/// The generator on harmonics up to the degree; column 0 vanishes. Each noise field that depends on the state adds half
/// the square of its own derivative, sigma_j(Pi) in front of L_j.
sparse_matrix backward_operator(const sphere_problem& problem, int degree);
/// The same from the functions of that degree to those two degrees higher: exact.
sparse_matrix tall_backward_operator(const sphere_problem& problem, int degree);

/// About the degree at which answers of any time settle: ten over the width to which the noise blurs what the drift
/// draws out, the root of noise over rate of shear. Noise about one axis crosses it only as far as shear turns it
/// there, while damping draws out. A rule of thumb. Infinite without noise.
double needed_degree(const sphere_problem& problem);

/// Trace of the covariance; of noise that depends on the state, the greatest on the sphere.
double noise_rate(const sphere_problem& problem);

}  // namespace polhode
