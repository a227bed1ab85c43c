// SPDX-License-Identifier: Apache-2.0
// Eigen's dense algebra for tests, compiled once (see src/algebra/decompositions.hpp).
#pragma once

#include <Eigen/Core>

namespace polhode::test {

Eigen::MatrixXd exponential_of(const Eigen::MatrixXd&);
Eigen::MatrixXd logarithm_of(const Eigen::MatrixXd&);  ///< the principal one
Eigen::VectorXcd complex_eigenvalues_of(const Eigen::MatrixXcd&);
Eigen::VectorXd solution_of(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

}  // namespace polhode::test
