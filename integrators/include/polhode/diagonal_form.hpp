// SPDX-License-Identifier: Apache-2.0
// Eigenvalues and eigenvectors of a small symmetric matrix.
#pragma once

#include <Eigen/Core>
#include <Eigen/Jacobi>
#include <cmath>
#include <limits>
#include <utility>

namespace polhode {

template <class Matrix>
struct diagonal_form {
  Eigen::Matrix<double, Matrix::RowsAtCompileTime, 1> values;  ///< rising
  Matrix axes;                                                 ///< eigenvectors, orthonormal columns
};

/// symmetric = axes diag(values) axes^T, by Jacobi's rotations, row after row until every entry off the diagonal
/// is lost beside the geometric mean of its two diagonal ones; a diagonal matrix is taken as it is. (Eigen's solver by
/// tridiagonal form takes twenty times as long to compile, for each size.) Range: finite entries, up to some fifty
/// rows. Source: Golub, Van Loan, Matrix Computations, 4th ed., 8.5.
template <class Matrix>
diagonal_form<Matrix> diagonal_form_of(const Matrix& symmetric) {
  constexpr int most_sweeps = 30;  // ten are many: convergence is quadratic
  const auto n = symmetric.rows();
  Matrix a = symmetric, axes = Matrix::Identity(n, n);
  bool turning = true;
  for (int sweep = 0; turning && sweep < most_sweeps; ++sweep) {
    turning = false;
    for (Eigen::Index p = 0; p < n; ++p)
      for (Eigen::Index q = p + 1; q < n; ++q) {
        const double lost =
            std::numeric_limits<double>::epsilon() * std::sqrt(std::fabs(a(p, p))) * std::sqrt(std::fabs(a(q, q)));
        if (std::fabs(a(p, q)) <= lost) continue;
        turning = true;
        Eigen::JacobiRotation<double> rotation;
        rotation.makeJacobi(a, p, q);
        a.applyOnTheLeft(p, q, rotation.adjoint());
        a.applyOnTheRight(p, q, rotation);
        a(p, q) = a(q, p) = 0;
        axes.applyOnTheRight(p, q, rotation);
      }
  }
  diagonal_form<Matrix> out{a.diagonal(), axes};
  for (Eigen::Index k = 0; k < n; ++k) {
    Eigen::Index least = k;
    for (auto i = k + 1; i < n; ++i)
      if (out.values[i] < out.values[least]) least = i;
    std::swap(out.values[k], out.values[least]);
    out.axes.col(k).swap(out.axes.col(least));
  }
  return out;
}

}  // namespace polhode
