// SPDX-License-Identifier: Apache-2.0
// Products of real orthonormal spherical harmonics, Y_k(x_1) Y_n(x_2), as a basis of functions on two spheres.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sphere/products/sphere_pair.hpp"
#include "sphere/site_observable.hpp"

namespace polhode {

/// 4 pi: a function's first coefficient over its mean on both spheres.
inline const double unit_of_pair_mean = 4 * std::numbers::pi;

/// So many of degree l_1 + l_2 up to this one: (L + 1)(L + 2)(L^2 + 3 L + 3)/6, the constant first. They are ordered by
/// that degree, so that those of a lower degree are the first of a higher one.
int pair_harmonic_count(int degree);

/// Where the products stand.
class pair_index {
 public:
  explicit pair_index(int degree);
  /// of Y_k(x_1) Y_n(x_2), k and n by harmonic_index, l_1 + l_2 up to the degree.
  int operator()(int k, int n) const;

 private:
  int degree_;
  std::vector<int> first_;  ///< [l_1][l_2]
};

/// Values of all of them at two unit vectors.
Eigen::VectorXd pair_harmonics_at(const Eigen::Vector3d& x1, const Eigen::Vector3d& x2, int degree);

/// A bound of the supremum: the sum over l_1, l_2 of sqrt((2 l_1 + 1)(2 l_2 + 1)) / 4 pi |f_l1l2|. Coefficients may
/// begin at any whole degree.
double pair_supremum(const Eigen::VectorXd& coefficients, int first_degree = 0);

/// Exact: observables are polynomials of degree two. degree >= 2.
Eigen::VectorXd pair_coefficients(const sphere_pair&, const site_observable&, int degree);

}  // namespace polhode
