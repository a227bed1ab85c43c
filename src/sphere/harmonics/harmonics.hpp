// SPDX-License-Identifier: Apache-2.0
// Real orthonormal spherical harmonics as a basis of linear algebra: values, quadrature, rotations, multiplication by
// x.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace polhode {

using sparse_matrix = Eigen::SparseMatrix<double>;
using sparse_entries = std::vector<Eigen::Triplet<double>>;
using points_on_sphere = Eigen::Matrix<double, Eigen::Dynamic, 3>;  ///< a unit vector a row

/// A square matrix from its entries; those at one place add up.
sparse_matrix sparse_from(int size, const sparse_entries&);

/// sqrt(4 pi): a function's first coefficient over its mean on the sphere, its norm over its root mean square.
inline const double unit_of_mean = std::sqrt(4 * std::numbers::pi);

constexpr int harmonic_count(int degree) { return (degree + 1) * (degree + 1); }

/// Y_lm, -l <= m <= l: cos(m phi) for m >= 0, sin(|m| phi) for m < 0, positive leading coefficient (no Condon-Shortley
/// sign).
constexpr int harmonic_index(int l, int m) { return l * l + l + m; }

/// Y(i, l^2 + l + m) = Y_lm(x_i), l <= degree. Recurrence in l, stable for every degree.
Eigen::MatrixXd harmonics(const points_on_sphere& x, int degree);
Eigen::VectorXd harmonics_at(const Eigen::Vector3d& x, int degree);

/// Gauss-Legendre in z times equal angles, ring after ring: exact for polynomials up to the given degree.
struct sphere_rule {
  points_on_sphere points;
  Eigen::VectorXd weights;  ///< they add up to 4 pi
  int per_ring;
};
sphere_rule sphere_quadrature(int degree);

/// Coefficients of f up to the degree, by the quadrature that is exact for products of two such functions.
Eigen::VectorXd harmonic_coefficients(const std::function<double(const Eigen::Vector3d& x)>& f, int degree);

/// L_i = (x cross grad)_i, (L_i f)(x) = d/de f(exp(e e_i^) x): antisymmetric, exact, [L_i, L_j] = -eps_ijk L_k.
std::array<sparse_matrix, 3> rotation_generators(int degree);

/// Multiplication by x_i, truncated: exact from degrees below the last one. Products of k of them are exact in the
/// upper left corner of degree - k + 1.
std::array<sparse_matrix, 3> coordinates(int degree);

}  // namespace polhode
