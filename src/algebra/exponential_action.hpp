// SPDX-License-Identifier: Apache-2.0
// exp(t A) b without exp(t A).
#pragma once

#include <Eigen/SparseCore>
#include <functional>

namespace polhode {

/// exp(t A) b by scaled and shifted Taylor series to double precision (Al-Mohy and Higham, SIAM J. Sci. Comput. 33
/// (2011) 488, algorithm 3.2 with m = 55): backward error below 2^-53 |tA|. t >= 0. Not finite where it overflows. It
/// proceeds in equal steps; watch sees the vector after each, and how long the step was, and says whether to go on.
Eigen::VectorXd exponential_action(const Eigen::SparseMatrix<double>& a, double t, Eigen::VectorXd b,
                                   const std::function<bool(const Eigen::VectorXd&, double dt)>& watch = {});

/// About how many products with A that takes.
double exponential_action_products(const Eigen::SparseMatrix<double>& a, double t);

}  // namespace polhode
