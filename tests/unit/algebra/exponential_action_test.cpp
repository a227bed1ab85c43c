// SPDX-License-Identifier: Apache-2.0
// The exponential of a sparse matrix on a vector, against the dense one; its blocks and null vectors.
#include "algebra/exponential_action.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "algebra/sparse_blocks.hpp"
#include "support/dense.hpp"

namespace polhode {
namespace {

TEST(ExponentialAction, IsTheExponential) {
  const Eigen::MatrixXd a = 3 * Eigen::MatrixXd::Random(40, 40);
  const Eigen::VectorXd b = Eigen::VectorXd::Random(40);
  const Eigen::VectorXd dense = test::exponential_of(0.9 * a) * b;
  EXPECT_LT((exponential_action(a.sparseView(), 0.9, b) - dense).norm(), 1e-12 * dense.norm());
}

TEST(SparseBlocks, AreFoundAndInvariantVectorsSolved) {
  // Two chains on {0, 2, 3} and {1, 4}; columns of a backward generator act on functions, column 0 being the constant.
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(5, 5);
  a(2, 2) = a(3, 3) = a(1, 1) = a(4, 4) = -1;
  a(0, 2) = 0.5;
  a(2, 3) = 0.25;
  a(1, 4) = 0.1;
  const sparse_matrix s = a.sparseView();
  EXPECT_EQ(connected_blocks(s), (std::vector<index_set>{{0, 2, 3}, {1, 4}}));
  const auto nu = left_null_vector(s, 5);
  ASSERT_TRUE(nu);
  EXPECT_LT((*nu - (Eigen::VectorXd(5) << 1, 0, 0.5, 0.125, 0).finished()).norm(), 1e-15);
  EXPECT_FALSE(left_null_vector(s, 2));
}

}  // namespace
}  // namespace polhode
