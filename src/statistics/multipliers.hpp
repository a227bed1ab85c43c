// SPDX-License-Identifier: Apache-2.0
// By what factor does a path answer to its noise, as dt -> 0?
//
// S_k: derivative of the true end point by the logarithm of a strength (experiments/common/driven_block.hpp). If a
// scheme solves the equation with the strengths 1 + eps_k, its error at dt is sum eps_k S_k + O(dt^p), and what is of
// order dt^p is orthogonal to the S_k but for O(dt). So eps(dt) = E[S S^T]^-1 E[S.error] = eps + c_1 dt + c_2 dt^2 + …,
// whose limit is found by a polynomial in dt, with weights fixed in advance. It sees an error of the noise to the first
// power, which in squared distances is hidden under the error at the finest dt.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "statistics/sample.hpp"

namespace polhode {

/// Of each path: S_j.S_k [path][j][k] and S_k.error [path][level][k], the finest `levels` levels, coarsest first.
struct response_data {
  int directions = 0, levels = 0;
  std::vector<double> gram, response;

  response_data() = default;
  response_data(int paths, int count, int finest);
  double* gram_of(int path) { return gram.data() + path * directions * directions; }
  double* response_of(int path, int level) { return response.data() + (path * levels + level) * directions; }
};

struct multiplier {
  bool known = false;       ///< false: the direction does nothing that the ones before it do not do
  interval_estimate error;  ///< eps, 95 %: of the sample, of a further power of dt where one is seen, and of the cells
  double sure = 0;          ///< half-width with the family-wise certainty `family_z`
  double size = 0;          ///< root of the mean square of S_k
};

/// Two-sided 1e-7: of ten thousand healthy verdicts none is refuted by chance.
inline constexpr double family_z = 5.33;

/// Weights of the values at these dt in the constant of a weighted least-squares polynomial; errors grow like dt.
Eigen::VectorXd constant_of_polynomial(std::span<const double> dt, int degree);

/// What a limit by a quadratic leaves open. first: how far the value at the finest dt is from it; second: the limit by
/// a line, and the standard error of that difference. As much of the second as is seen beyond its error, or what the
/// next power adds if the corrections go on as they began, like those of a geometric series, where that is less.
double left_open(std::span<const double> dt, double first, double second, double error);

/// dt: of those levels, each half the one before, at least three; cells: of the truth in the finest step, to one of
/// which the limit is known. Not finite where a path is not.
std::vector<multiplier> effective_multipliers(std::span<const double> dt, const response_data&, int paths, int cells);

}  // namespace polhode
