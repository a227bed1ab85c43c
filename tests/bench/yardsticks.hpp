// SPDX-License-Identifier: Apache-2.0
// What the schemes are held beside, on the body of the scene `paper`: I = (1, 2, 3), theta = sigma = 1/2.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "bench/measure.hpp"
#include "ensemble/simulation.hpp"
#include "platform/isa.hpp"
#include "reports/model/results.hpp"

namespace polhode::bench {

using momentum = std::array<double, 3>;
enum class yard_scheme { heun, strang, lie_heun };

/// Independent multiplications and additions, fused where the instruction set has that: flops.
loop peak_loop(isa);

/// The hand-specialised kernel of Heun without noise: the states after `steps`, [component][path].
std::vector<double> heun_by_hand(isa, const report::scene&, int steps, double dt);
loop by_hand_loop(isa, const report::scene&, int steps, double dt);

/// Scalar, one path after another: Eigen, the library's sines, std::normal_distribution on std::mt19937_64. The common
/// noise is given, [step][channel], as increments of W.
momentum eigen_std(yard_scheme, ensemble_noise, momentum start, std::span<const double> common, int steps, double dt);

/// Structure of arrays, one `omp simd` loop over all paths a step, Boost's ziggurat on boost::random::mt19937_64.
std::vector<double> soa_ziggurat_heun(ensemble_noise, momentum start, std::span<const double> common, int steps,
                                      double dt);
inline constexpr int soa_paths = 256;

/// Boost.Odeint's rk4 without noise.
momentum odeint_rk4(momentum start, int steps, double dt);

/// A block of paths with increments of their own, [step][channel][path]: the states after `steps`, [component][path].
/// By a program that has the installed headers alone; and by the laboratory's loop over a system as it is, with a
/// double in the place of a pack.
std::vector<double> by_headers(yard_scheme, momentum start, std::span<const double> dw, int steps, double dt);
std::vector<double> by_scalar_kernel(yard_scheme, momentum start, std::span<const double> dw, int steps, double dt);

/// `count` standard normals added up.
double sum_of_std_normals(int count);
double sum_of_boost_normals(int count);
double sum_of_gsl_normals(int count);

}  // namespace polhode::bench
