// SPDX-License-Identifier: Apache-2.0
// Do these transitions follow that law? And if not, which one?
//
// Y / sqrt(V) of each test is normal, and Y^T V^-1 Y chi squared, as the number of transitions grows: martingale
// differences of known conditional covariance, whatever wrote the data and whatever step it took inside. The largest
// |Y / sqrt(V)| is held against half of the declared budget of false alarms, shared among the tests; the sum of squares
// against the other half.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "recorded/transition_moments.hpp"

namespace polhode {

inline constexpr double transitions_a_test = 40, fewest_transitions = 3 * transitions_a_test;
inline constexpr double false_alarms = 1e-3;  ///< of the whole test, on data that follow the law

/// Tests of so low degrees that each rests on enough transitions; none below the fewest.
struct test_family {
  int after = 0, before = -1;  ///< degrees of f and g
  int tests() const { return after == 0 ? 0 : (harmonic_count(after) - 1) * harmonic_count(before); }
};
test_family family_for(double transitions);

struct transition_finding {
  test_family family;
  Eigen::VectorXd z = {};  ///< of each test
  double largest = 0;      ///< |z|
  double critical = 0;     ///< for it
  std::string where = {};  ///< of which test, in words
  double squares = 0;      ///< Y^T V^-1 Y
  int rank = 0;            ///< its degrees of freedom
  double p_largest = 1, p_squares = 1;

  bool refuted() const { return p_largest < false_alarms / 2 || p_squares < false_alarms / 2; }
};

/// residual, variance: of all tests (transition_moments.hpp).
transition_finding test_transitions(const Eigen::VectorXd& residual, const Eigen::MatrixXd& variance,
                                    double transitions);

/// The rows of a family among all tests.
std::vector<Eigen::Index> rows_of(const test_family&);

}  // namespace polhode
