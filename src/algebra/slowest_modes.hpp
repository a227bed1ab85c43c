// SPDX-License-Identifier: Apache-2.0
// The slow end of a spectrum: eigenvalues of largest real part, and one eigenpair with both vectors.
#pragma once

#include <Eigen/Core>
#include <complex>

#include "algebra/sparse_blocks.hpp"

namespace polhode {

/// The eigenvalue of largest real part: of all where the matrix is small enough to be taken whole, else of those next
/// to zero (Arnoldi on the inverse). Minus infinity if none is found.
std::complex<double> slowest_rate(const sparse_matrix& a);

struct eigenpair {
  std::complex<double> rate;
  Eigen::VectorXcd right;  ///< of norm one
  double condition;        ///< |left| |right| / |left . right|: what a perturbation of A does to the rate
  double rounding;         ///< of the rate, by that of A's entries and products
};

/// The one next to the guess, by inverse iteration on both sides. The rate is their Rayleigh quotient; not finite where
/// the iteration breaks down.
eigenpair eigenpair_near(const sparse_matrix& a, std::complex<double> guess);

}  // namespace polhode
