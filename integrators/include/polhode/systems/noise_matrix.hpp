// SPDX-License-Identifier: Apache-2.0
// Noise vectors as the columns of a matrix: their class, and the ones of weak order two.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include <polhode/diagonal_form.hpp>
#include <polhode/vec.hpp>

namespace polhode {

/// One function, as each form of a product costs every user's compiler anew; entry by entry, as blocks of large
/// matrices cost it more.
template <class Matrix>
Matrix product(const Matrix& a, const Matrix& b) {
  return a.lazyProduct(b);
}

/// m m^T.
template <class Matrix>
Matrix square_of(const Matrix& m) {
  return m.lazyProduct(m.transpose());
}

/// On this depend the orders that a scheme may claim. One vector commutes with itself; isotropic: sum sigma sigma^T =
/// s^2 1; state_dependent: several vectors that are functions of the state.
enum class noise_class { none, one_vector, isotropic, general, state_dependent };

/// All columns along the longest, to rounding; sigma is not zero.
template <class Matrix>
bool of_rank_one(const Matrix& sigma) {
  const auto n = sigma.rows();
  Eigen::Index longest = 0;
  for (Eigen::Index i = 1; i < n; ++i)
    if (sigma.col(i).squaredNorm() > sigma.col(longest).squaredNorm()) longest = i;
  double across = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double along = sigma.col(i).dot(sigma.col(longest)) / sigma.col(longest).squaredNorm();
    for (Eigen::Index k = 0; k < n; ++k) across = std::max(across, std::abs(sigma(k, i) - along * sigma(k, longest)));
  }
  return across <= static_cast<double>(n) * std::numeric_limits<double>::epsilon() * sigma.norm();
}

/// Of a square matrix whose columns are the vectors.
template <class Matrix>
noise_class class_of(const Matrix& sigma) {
  const auto n = sigma.rows();
  const double scale = sigma.squaredNorm() / static_cast<double>(n);
  if (scale == 0) return noise_class::none;
  if (of_rank_one(sigma)) return noise_class::one_vector;
  const Matrix covariance = square_of(sigma);
  return (covariance - scale * Matrix::Identity(n, n)).norm() <= 1e-12 * scale ? noise_class::isotropic
                                                                               : noise_class::general;
}

/// Negative eigenvalues are taken for zero.
template <class Matrix>
Matrix square_root_of(const Matrix& symmetric) {
  auto [values, scaled] = diagonal_form_of(symmetric);
  for (Eigen::Index k = 0; k < scaled.cols(); ++k) scaled.col(k) *= std::sqrt(std::sqrt(std::max(values[k], 0.0)));
  return square_of(scaled);
}

/// An orthogonal O with sigma = square_root_of(sigma sigma^T) O, to 1e-7 of sigma: the images of the eigenvectors of
/// sigma sigma^T, from the longest on orthonormal, those that vanish replaced. (A singular value decomposition is this
/// in one line, and half a second of every user's compiler.)
template <class Matrix>
Matrix polar_rotation_of(const Matrix& sigma) {
  const Matrix transposed = sigma.transpose();
  const auto axes = diagonal_form_of(square_of(sigma)).axes;
  Matrix images = product(transposed, axes);
  const auto n = images.cols();
  if (const double longest = images.col(n - 1).norm(); longest > 0) images /= longest;
  for (auto k = n - 1; k >= 0; --k) {
    auto image = images.col(k);
    const auto project = [&] {
      for (int twice = 0; twice < 2; ++twice)
        for (auto j = k + 1; j < n; ++j) image -= images.col(j).dot(image) * images.col(j);
    };
    project();
    for (Eigen::Index axis = 0; image.norm() <= 1e-8; ++axis) {
      image.setUnit(axis);
      project();
    }
    image /= image.norm();
  }
  images.transposeInPlace();
  return product(axes, images);
}

/// [v, .] as a matrix.
template <class Algebra, class Matrix>
Matrix adjoint_of(const Matrix& sigma, Eigen::Index column) {
  using element = vec<double, Algebra::dimension>;
  const int n = static_cast<int>(sigma.rows());
  auto v = zeros<element>(n);
  for (int k = 0; k < n; ++k) v[k] = sigma(k, column);
  Matrix ad(n, n);
  for (int k = 0; k < n; ++k) {
    auto e = zeros<element>(n);
    e[k] = 1;
    const auto image = Algebra::bracket(v, e);
    for (int row = 0; row < n; ++row) ad(row, k) = image[row];
  }
  return ad;
}

/// Noise vectors T(dt) for which one exponential of T dW has the law of the Brownian motion on the group to weak
/// order two, for any sigma on any Lie algebra. With X_i the vector fields of sigma_i,
///   exp(dt/2 sum X_i^2) - E exp(sum X_i dW^i) = dt^2/2 sum_ab R_ab e_a e_b + O(dt^3),
///   R = (M Q + Q M^T)/12 + 1/4 sum_{i<j} [sigma_i,sigma_j][sigma_i,sigma_j]^T,
///   Q = sum sigma_i sigma_i^T,  M = sum_i ad(sigma_i)^2,
/// so that the covariance Q dt + R dt^2 removes the defect (both sides expanded to dt^2: the words iijj, ijij, ijji
/// carry 1/8, 0, 0 on the left; 1/24 each on the right, plus 1/12, -1/6, 1/12 from M and 0, 1/8, -1/8 from the
/// brackets). Isotropic noise on so(3): R = -sigma^4/12, the factor sqrt(1 - sigma^2 dt/12). One vector: R = 0.
/// T(dt) -> sigma as dt -> 0. Where dt is so large that Q + R dt is indefinite its negative part is dropped.
/// brackets: [sigma_i, sigma_j], i < j, those that are not zero at least.
template <class Algebra, class Matrix, class Brackets>
Matrix weak_order_two_vectors(const Matrix& sigma, const Brackets& brackets, double dt) {
  const auto n = sigma.rows();
  const Matrix covariance = square_of(sigma);
  Matrix m = Matrix::Zero(n, n), r = Matrix::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Matrix ad = adjoint_of<Algebra>(sigma, i);
    m += product(ad, ad);
  }
  for (const auto& b : brackets) {
    const Eigen::Map<const Eigen::Matrix<double, Matrix::RowsAtCompileTime, 1>> e(b.begin(), n);
    r += 0.25 * e * e.transpose();
  }
  m = product(m, covariance);
  r += (m + m.transpose()) / 12.0;
  return product(square_root_of<Matrix>(covariance + dt * r), polar_rotation_of(sigma));
}

}  // namespace polhode
