// SPDX-License-Identifier: Apache-2.0
// Eigenvalues in closed form, and of what has none.
#include "algebra/decompositions.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace polhode {
namespace {

// Of a turn and a stretch: 2 exp(+-i 0.3).
TEST(Decompositions, EigenvaluesOfATurnAreComplex) {
  Eigen::Matrix2d turn;
  turn << std::cos(0.3), -std::sin(0.3), std::sin(0.3), std::cos(0.3);
  const Eigen::VectorXcd found = eigenvalues_of(2 * turn);
  EXPECT_NEAR(std::abs(found[0]), 2, 1e-14);
  EXPECT_NEAR(std::fabs(std::arg(found[0])), 0.3, 1e-14);
  EXPECT_EQ(found[1], std::conj(found[0]));
}

TEST(Decompositions, EigenvaluesOfWhatIsNotFiniteAreNoNumbers) {
  for (const double wrong : {HUGE_VAL, double{NAN}}) {
    Eigen::MatrixXd a = Eigen::MatrixXd::Identity(3, 3);
    a(1, 2) = wrong;
    EXPECT_TRUE(std::isnan(eigenvalues_of(a).real().sum())) << wrong;
  }
}

}  // namespace
}  // namespace polhode
