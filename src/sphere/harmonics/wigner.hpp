// SPDX-License-Identifier: Apache-2.0
// Functions on the rotation group as linear algebra: Wigner functions, real and orthonormal, of R = (v, w, x).
#pragma once

#include <array>

#include "sphere/harmonics/harmonics.hpp"

namespace polhode {

constexpr int wigner_count(int degree) { return (degree + 1) * (2 * degree + 1) * (2 * degree + 3) / 3; }

/// F_l,ab, -l <= a, b <= l: a turns with R from the left like Y_la, b from the right; degrees are contiguous.
constexpr int wigner_index(int l, int a, int b) { return wigner_count(l - 1) + (a + l) * (2 * l + 1) + (b + l); }

/// (left_i F)(R) = d/de F(exp(e e_i^) R),  (right_i F)(R) = d/de F(R exp(e e_i^)). Exact inside each degree,
/// [left_i, left_j] = -eps_ijk left_k, [right_i, right_j] = eps_ijk right_k, and the two commute.
struct group_generators {
  std::array<sparse_matrix, 3> left, right;
};
group_generators wigner_generators(int degree);

/// Multiplication by x_i = R_i3, truncated as in harmonics.hpp. What belongs to the other columns follows from
/// [right_j, .], which turns the columns: right_1 x = -w, right_2 x = v, right_2 w = 0, right_1 v = 0.
std::array<sparse_matrix, 3> wigner_coordinates(int degree, const group_generators& turn);

/// A bound of |f| over all frames, from the coefficients of whole degrees: functions of one l and right index b are at
/// most sqrt(2 l + 1) |f_lb|, as the rows of a rotation are unit vectors.
double frame_supremum(const Eigen::VectorXd& f);

}  // namespace polhode
