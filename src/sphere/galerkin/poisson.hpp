// SPDX-License-Identifier: Apache-2.0
// Stationary means with a proved bar, by Poisson's equation and the maximum principle.
//
// If A u = f - m - r with a remainder r, then under every stationary law E[A u] = 0, so |E[f] - m| <= sup |r|. A
// Galerkin solution u of degree L leaves a remainder in degrees L + 1 and L + 2 only, which is known exactly. Nothing
// is asked of the law: where there are several, the remainder stays large unless all give f the same mean.
#pragma once

#include <functional>

#include "algebra/sparse_blocks.hpp"
#include "sphere/galerkin/raise_degree.hpp"

namespace polhode {

/// A bound of the supremum of |f|, from the coefficients of f.
using supremum_bound = std::function<double(const Eigen::VectorXd& coefficients)>;

/// tall: the generator from the functions of one degree (columns, the constant first) to those two degrees higher
/// (rows). f: coefficients of as many functions as tall has columns. most: unknowns that are affordable. The value is
/// the coefficient of the constant function. Empty if the block is too large or the operator singular.
std::optional<projected_value> poisson_mean(const sparse_matrix& tall, const Eigen::VectorXd& f, int most,
                                            const supremum_bound& supremum);

/// Of spherical harmonics: sum over l of sqrt((2 l + 1) / 4 pi) |f_l|. Coefficients may begin at any whole degree.
double harmonic_supremum(const Eigen::VectorXd& coefficients, int first_degree = 0);

}  // namespace polhode
