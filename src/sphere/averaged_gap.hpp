// SPDX-License-Identifier: Apache-2.0
// The spectral gap where noise and dissipation are so weak that a body circles many times before either shows.
//
// Then only the energy diffuses, along a graph: an edge for each family of circles about an axis of least or greatest
// energy, both signs, all ends of separatrices in one vertex. On an edge, with y the distance from the axis in energy,
//
//   -(a p u')' = lambda T p u,   a = 1/2 sum_i Q_ii J_i,   J_i = closed integral of (Pi x Omega)_i^2 dt,   p =
//   exp(-beta h)
//
// T the period; natural at the axis, where a vanishes. Odd modes, of opposite sign on the two edges of an axis, vanish
// at the vertex; even ones are continuous there. Off-diagonal noise averages out by the symmetry of the circles.
// Source: Freidlin, Wentzell, Random Perturbations of Dynamical Systems (3rd ed. 2012), chapter 8.
#pragma once

#include <optional>

#include "sphere/sphere_problem.hpp"

namespace polhode {

struct averaged_rates {
  double odd;   ///< the slowest on which two opposite families differ
  double even;  ///< the slowest on which they agree, besides the constant
  double gap() const { return odd < even ? odd : even; }
};

/// The limit of the spectral gap in units of the noise, as noise and theta fade in proportion (theta > 0: under
/// isotropic noise, beta = 2 theta / sigma^2), to about 1e-6 of itself, 3e-6 where two inertias differ by a thousandth.
/// The gap itself falls short by about sigma times a logarithm. Nothing for a spherical body, no noise, an h with
/// products of two components or a field, noise that depends on the state, or where p under- or overflows.
std::optional<averaged_rates> averaged_gap(const sphere_problem& problem);

}  // namespace polhode
