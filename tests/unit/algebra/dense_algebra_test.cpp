// SPDX-License-Identifier: Apache-2.0
// Eigen's products and solution on every instruction set: what Eigen gives where it stands, also for parts of matrices.
#include "algebra/dense_algebra.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "platform/isa.hpp"

namespace polhode::test {
namespace {

/// Neither symmetric nor a multiple of any pack in size.
Eigen::MatrixXd some_matrix(Eigen::Index rows, Eigen::Index columns, double seed) {
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [=](Eigen::Index i, Eigen::Index k) {
    return std::sin(seed + 1.7 * static_cast<double>(i) + 0.3 * static_cast<double>(k * k)) + (i == k ? 3 : 0);
  });
}

template <class Body>
void on_every_isa(const Body& body) {
  for (const isa level : usable_isas()) {
    choose_isa(level);
    body(name_of(level));
  }
  choose_isa(usable_isas().back());
}

TEST(DenseAlgebra, AddsProductsOfPartsOfMatrices) {
  const auto a = some_matrix(31, 23, 1), b = some_matrix(29, 19, 2), c = some_matrix(37, 41, 3);
  on_every_isa([&](auto level) {
    Eigen::MatrixXd sum = c;
    add_product(a.block(2, 1, 13, 17), b.block(3, 2, 17, 11), sum.block(1, 4, 13, 11));
    Eigen::MatrixXd expected = c;
    expected.block(1, 4, 13, 11) += a.block(2, 1, 13, 17) * b.block(3, 2, 17, 11);
    EXPECT_LT((sum - expected).cwiseAbs().maxCoeff(), 1e-13) << level;

    sum = expected = c;
    add_transposed_product(a.block(2, 1, 13, 17), b.block(3, 2, 13, 11), sum.block(1, 4, 17, 11));
    expected.block(1, 4, 17, 11) += a.block(2, 1, 13, 17).transpose() * b.block(3, 2, 13, 11);
    EXPECT_LT((sum - expected).cwiseAbs().maxCoeff(), 1e-13) << level;
  });
}

TEST(DenseAlgebra, SolvesFromTheLeft) {
  const auto a = some_matrix(40, 40, 4);
  const Eigen::RowVectorXd x = some_matrix(1, 33, 5);
  on_every_isa([&](auto level) {
    const auto part = a.block(3, 2, 33, 33);
    const auto found = solve_from_left(part, x * part);
    EXPECT_LT((found - x).cwiseAbs().maxCoeff(), 1e-11) << level;
    const Eigen::MatrixXd one = inverse_of(part) * part;
    EXPECT_LT((one - Eigen::MatrixXd::Identity(33, 33)).cwiseAbs().maxCoeff(), 1e-11) << level;
  });
}

}  // namespace
}  // namespace polhode::test
