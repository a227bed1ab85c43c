// SPDX-License-Identifier: Apache-2.0
// log(T) b without log(T).
#pragma once

#include <Eigen/Core>
#include <optional>

namespace polhode {

/// log(T) b for the principal logarithm, a column at a time, by Arnoldi's process on T - 1: log(T) b is about
/// |b| V log(1 + H) e_1 on the Krylov space of dimension m (Higham, Functions of Matrices, SIAM 2008, 13.2), m raised
/// until two successive answers agree to `tolerance` of |T b - b|. Only the modes that b excites have to lie off the
/// negative axis: what a truncated operator does to its highest harmonics does not matter. Empty where it does not
/// converge.
std::optional<Eigen::MatrixXd> logarithm_action(const Eigen::MatrixXd& t, const Eigen::MatrixXd& b,
                                                double tolerance = 1e-11);

}  // namespace polhode
