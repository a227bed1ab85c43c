// SPDX-License-Identifier: Apache-2.0
// Eigen's dense algebra for tests, compiled once (see src/algebra/decompositions.hpp).
#pragma once

#include <Eigen/Core>

namespace polhode::test {

Eigen::MatrixXd exponential_of(const Eigen::MatrixXd&);

/// X of A X = B.
Eigen::MatrixXd solution_of(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// The x for which |A x - b| is least.
Eigen::VectorXd least_squares_of(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// A complex matrix A + i B as the real one with rows (A, -B), (B, A), whose eigenvalues are those of A + i B and their
/// conjugates; and back. Products, inverses and exponentials go over into each other.
Eigen::MatrixXd real_form(const Eigen::MatrixXcd&);
Eigen::MatrixXcd complex_form(const Eigen::MatrixXd&);

}  // namespace polhode::test
