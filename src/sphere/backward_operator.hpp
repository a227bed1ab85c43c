// The generator of a diffusion on the sphere in spherical harmonics (sphere/kolmogorov.hpp), and how fine what it makes
// of a function becomes.
#pragma once

#include "sphere/harmonics.hpp"
#include "sphere/sphere_problem.hpp"

namespace polhode {

/// The generator on harmonics up to the degree; column 0 vanishes. Each noise field that depends on the state adds half
/// the square of its own derivative, sigma_j(Pi) in front of L_j.
sparse_matrix backward_operator(const sphere_problem& problem, int degree);

/// About the degree at which answers of any time settle: ten over the width to which the noise blurs what the drift
/// draws out, the root of noise over rate of shear. Noise about one axis crosses it only as far as shear turns it
/// there, while damping draws out. A rule of thumb. Infinite without noise.
double needed_degree(const sphere_problem& problem);

/// Trace of the covariance; of noise that depends on the state, the greatest on the sphere.
double noise_rate(const sphere_problem& problem);

}  // namespace polhode
