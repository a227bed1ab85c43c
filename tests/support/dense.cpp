// SPDX-License-Identifier: Apache-2.0
#include "support/dense.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <unsupported/Eigen/MatrixFunctions>

namespace polhode::test {

Eigen::MatrixXd exponential_of(const Eigen::MatrixXd& a) { return a.exp(); }
Eigen::MatrixXd logarithm_of(const Eigen::MatrixXd& a) { return a.log(); }
Eigen::VectorXcd complex_eigenvalues_of(const Eigen::MatrixXcd& a) {
  return Eigen::ComplexEigenSolver<Eigen::MatrixXcd>(a, false).eigenvalues();
}
Eigen::VectorXd solution_of(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) { return a.partialPivLu().solve(b); }

}  // namespace polhode::test
