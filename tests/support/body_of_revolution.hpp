// SPDX-License-Identifier: Apache-2.0
// Bodies of revolution under noise that is alike across the figure axis: one dimension, z = Pi_figure / c.
//
//   u(z) (1 - z^2)^(m/2) exp(i m phi):   L_m = q/2 [(1 - z^2) u'' - 2 (m + 1) z u' - m (m + 1) u]
//                                            + d [z (1 - z^2) u' - m z^2 u] + i m w z u - (r - q) m^2 / 2 u
//
// q the noise across the axis, r along it, d = theta c^2 (k - k_figure), w = c (k_figure - k), k = 1 / I. Chebyshev
// collocation in z; the equation degenerates at both ends, so that being smooth is all there is to ask there.
//
// Tangent directions: with a frame R = (v, w, x), n = R^T e_figure = (v, w, x)_figure is itself a diffusion on a
// sphere, under the noise q in all directions, and s a function of it. With D = c (k_figure - k), t = theta c:
//
//   n' = -D (n_1^2 - t n_1 n_2) e_3 x n + t D n_3 (e_3 x n) x n,   s = -D n_1 n_2 + t D (n_3^2 - n_1^2).
#pragma once

#include <optional>

#include "sphere/sphere_problem.hpp"

namespace polhode::test {

struct body_of_revolution {
  int axis;
  double c, theta, k, figure;  ///< inverse inertia across and along the axis
  double across, along;        ///< noise
};

/// Empty for other bodies or other noise.
std::optional<body_of_revolution> revolution(const sphere_problem&);

/// E[h] at a time.
double energy_on_a_line(const body_of_revolution&, double z, double time, int n);

/// The gap over |m| <= most: the rates of larger m only grow.
double gap_on_a_line(const body_of_revolution&, int n, int most);

double lambda1_on_the_sphere(const body_of_revolution&, int n);

}  // namespace polhode::test
