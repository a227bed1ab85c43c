// SPDX-License-Identifier: Apache-2.0
// What the transitions of one interval say about an equation on a sphere, as sums.
//
// With P = exp(dt L), f and g harmonics, Y = [f(X') - (P f)(X)] g(X) has mean zero given X, and the conditional
// covariance of Y_fg and Y_f'g' is [(P f f')(X) - (P f)(X) (P f')(X)] g(X) g'(X) (MODEL: the exact transition test).
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "sphere/expectations/transition.hpp"
#include "sphere/harmonics/harmonics.hpp"

namespace polhode {

inline constexpr int degree_after = 3, degree_before = 2;  ///< of f and of g
/// Tests f(X') g(X), g a column of f's: all f of degree 1 … degree_after, f running fastest.
inline constexpr int functions_after = harmonic_count(degree_after) - 1,
                     functions_before = harmonic_count(degree_before), all_tests = functions_after * functions_before;

struct transition_sums {
  double count = 0;
  Eigen::MatrixXd joint;     ///< sum f(X') g(X): f of degree 0 … degree_after a row, g a column
  Eigen::MatrixXd before;    ///< sum Y(X) g(X): every harmonic of the operator a row
  Eigen::MatrixXd variance;  ///< sum of the conditional covariances, a row and a column a test
  Eigen::MatrixXd observed;  ///< sum Y Y^T

  /// sum Y, a test a row, under the law whose columns these are.
  Eigen::VectorXd residual(const Eigen::MatrixXd& columns) const;
};

class transition_moments {
 public:
  /// law: of harmonics to twice degree_after.
  explicit transition_moments(transition_law law);

  /// Unit vectors.
  void add(const Eigen::Vector3d& before, const Eigen::Vector3d& after);
  const transition_law& law() const { return law_; }
  /// Of all that was added.
  const transition_sums& sums();

 private:
  void flush();

  transition_law law_;
  Eigen::MatrixXd products_;  ///< f f' in harmonics: a row a pair f <= f'
  points_on_sphere before_, after_;
  Eigen::Index held_ = 0;
  Eigen::MatrixXd pairs_;  ///< sum of cov(f, f') g g': a row a pair f <= f', a column a pair g <= g'
  transition_sums sums_;
};

}  // namespace polhode
