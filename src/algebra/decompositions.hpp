// SPDX-License-Identifier: Apache-2.0
// Eigen's decompositions of real matrices, compiled once, in decompositions.cpp: a source that instantiates one takes
// up to ten seconds more.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseLU>

extern template class Eigen::SparseLU<Eigen::SparseMatrix<double>>;

namespace polhode {

/// Of a square matrix, in no order; no numbers where they are not found.
Eigen::VectorXcd eigenvalues_of(const Eigen::MatrixXd&);

struct eigenpairs {
  Eigen::VectorXcd values;
  Eigen::MatrixXcd vectors;  ///< columns of norm one
};
eigenpairs eigenpairs_of(const Eigen::MatrixXd&);

struct symmetric_eigenpairs {
  Eigen::VectorXd values;   ///< increasing
  Eigen::MatrixXd vectors;  ///< orthonormal columns
};
/// Of a symmetric matrix: its lower half is read.
symmetric_eigenpairs symmetric_eigenpairs_of(const Eigen::MatrixXd&);

/// The values of A x = value B x, increasing; A symmetric, B symmetric and positive definite.
Eigen::VectorXd generalised_eigenvalues_of(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// The Moore-Penrose inverse: pseudo_inverse(A) b is the least-squares solution of A x = b of least norm. Where A is
/// square and regular it is the inverse.
Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd&);

}  // namespace polhode
