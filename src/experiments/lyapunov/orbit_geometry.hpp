// SPDX-License-Identifier: Apache-2.0
// The coadjoint orbit about a state: its tangent space, its Liouville volume, and the divergence of the drift on it.
//
// The tangent space at mu is the range of the Poisson tensor J(mu) xi = ad*_xi mu, an antisymmetric matrix; on it the
// symplectic form of Kirillov, Kostant and Souriau is J^-1. So a body of Euclidean volume V there has the Liouville
// volume V / sqrt(det J), the determinant that of J on its range. (Marsden, Ratiu, Introduction to Mechanics and
// Symmetry, 2nd ed., chapter 14.)
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "ensemble/model.hpp"

namespace polhode {

class orbit_geometry {
 public:
  /// Of the orbits of this momentum's dimension.
  orbit_geometry(const model&, std::span<const double> momentum);

  /// That of the momentum less the number of independent Casimirs there; even.
  int dimension() const { return dimension_; }

  /// Orthonormal columns that span the tangent space at a state.
  Eigen::MatrixXd tangents(const Eigen::VectorXd& mu) const;

  /// log of Liouville's volume over Euclid's at a state.
  double log_density(const Eigen::VectorXd& mu) const;

  /// Of a block of states: of the drift ad*_a(mu) mu with respect to Liouville's volume: the trace of its derivative in
  /// the space of all momenta, by differences of fourth order, exact to rounding for polynomials of degree four. Both
  /// agree where the algebra is unimodular (tr ad = 0): Lebesgue's and Liouville's volume then are both invariant under
  /// every ad*_xi, so they differ by a function of the Casimirs. For the same reason the Hamiltonian part of the drift
  /// and the noise add nothing.
  Eigen::VectorXd divergences(std::span<const double> states) const;

 private:
  Eigen::MatrixXd poisson_tensor(const Eigen::VectorXd& mu) const;

  const model& model_;
  std::vector<Eigen::MatrixXd> coadjoint_;
  int dimension_ = 0;
};

}  // namespace polhode
