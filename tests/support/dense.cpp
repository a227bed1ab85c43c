// SPDX-License-Identifier: Apache-2.0
#include "support/dense.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <unsupported/Eigen/MatrixFunctions>

namespace polhode::test {

Eigen::MatrixXd exponential_of(const Eigen::MatrixXd& a) { return a.exp(); }

Eigen::MatrixXd solution_of(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) { return a.partialPivLu().solve(b); }

Eigen::VectorXd least_squares_of(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return a.colPivHouseholderQr().solve(b);
}

Eigen::MatrixXd real_form(const Eigen::MatrixXcd& a) {
  Eigen::MatrixXd out(2 * a.rows(), 2 * a.cols());
  out << a.real(), -a.imag(), a.imag(), a.real();
  return out;
}

Eigen::MatrixXcd complex_form(const Eigen::MatrixXd& a) {
  const Eigen::Index rows = a.rows() / 2, columns = a.cols() / 2;
  Eigen::MatrixXcd out(rows, columns);
  out.real() = a.topLeftCorner(rows, columns);
  out.imag() = a.bottomLeftCorner(rows, columns);
  return out;
}

}  // namespace polhode::test
