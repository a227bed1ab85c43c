// SPDX-License-Identifier: Apache-2.0
#include "algebra/decompositions.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <cmath>

template class Eigen::SparseLU<Eigen::SparseMatrix<double>>;

namespace polhode {

Eigen::VectorXcd eigenvalues_of(const Eigen::MatrixXd& a) {
  const Eigen::EigenSolver<Eigen::MatrixXd> eigen(a, false);
  if (!a.allFinite() || eigen.info() != Eigen::Success) return Eigen::VectorXcd::Constant(a.rows(), NAN);
  return eigen.eigenvalues();
}

eigenpairs eigenpairs_of(const Eigen::MatrixXd& a) {
  const Eigen::EigenSolver<Eigen::MatrixXd> eigen(a);
  return {eigen.eigenvalues(), eigen.eigenvectors()};
}

symmetric_eigenpairs symmetric_eigenpairs_of(const Eigen::MatrixXd& a) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(a);
  return {eigen.eigenvalues(), eigen.eigenvectors()};
}

Eigen::VectorXd generalised_eigenvalues_of(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(a, b, Eigen::EigenvaluesOnly).eigenvalues();
}

Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& a) {
  return Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(a).pseudoInverse();
}

}  // namespace polhode
