// SPDX-License-Identifier: Apache-2.0
#include "recorded/transition_moments.hpp"

#include <utility>

namespace polhode {
namespace {

constexpr Eigen::Index batch = 512;

constexpr Eigen::Index pair_count(Eigen::Index n) { return n * (n + 1) / 2; }
constexpr Eigen::Index pair_index(Eigen::Index i, Eigen::Index j) {
  return i <= j ? j * (j + 1) / 2 + i : i * (i + 1) / 2 + j;
}

/// Columns i, j multiplied, i <= j.
Eigen::MatrixXd products_of_columns(const Eigen::MatrixXd& a) {
  Eigen::MatrixXd out(a.rows(), pair_count(a.cols()));
  for (Eigen::Index j = 0; j < a.cols(); ++j)
    for (Eigen::Index i = 0; i <= j; ++i) out.col(pair_index(i, j)) = a.col(i).cwiseProduct(a.col(j));
  return out;
}

/// Exact: products have twice the degree.
Eigen::MatrixXd products_in_harmonics() {
  const auto rule = sphere_quadrature(4 * degree_after);
  const Eigen::MatrixXd y = harmonics(rule.points, 2 * degree_after);
  const Eigen::MatrixXd products = products_of_columns(y.middleCols(1, functions_after));
  return products.transpose() * rule.weights.asDiagonal() * y;
}

/// Of each row: left (x) right, left running fastest.
Eigen::MatrixXd row_products(const Eigen::MatrixXd& left, const Eigen::MatrixXd& right) {
  Eigen::MatrixXd out(left.rows(), left.cols() * right.cols());
  for (Eigen::Index j = 0; j < right.cols(); ++j)
    out.middleCols(j * left.cols(), left.cols()) = left.array().colwise() * right.col(j).array();
  return out;
}

}  // namespace

Eigen::VectorXd transition_sums::residual(const Eigen::MatrixXd& columns) const {
  const Eigen::MatrixXd difference =
      (joint - columns.leftCols(functions_after + 1).transpose() * before).bottomRows(functions_after);
  return difference.reshaped();
}

transition_moments::transition_moments(transition_law law)
    : law_(std::move(law)),
      products_(products_in_harmonics()),
      before_(batch, 3),
      after_(batch, 3),
      pairs_(Eigen::MatrixXd::Zero(pair_count(functions_after), pair_count(functions_before))) {
  sums_.joint = Eigen::MatrixXd::Zero(functions_after + 1, functions_before);
  sums_.before = Eigen::MatrixXd::Zero(law_.columns.rows(), functions_before);
  sums_.variance = sums_.observed = Eigen::MatrixXd::Zero(all_tests, all_tests);
}

void transition_moments::add(const Eigen::Vector3d& before, const Eigen::Vector3d& after) {
  before_.row(held_) = before;
  after_.row(held_) = after;
  if (++held_ == batch) flush();
}

void transition_moments::flush() {
  if (held_ == 0) return;
  const Eigen::MatrixXd y = harmonics(before_.topRows(held_), law_.degree),
                        f = harmonics(after_.topRows(held_), degree_after), g = y.leftCols(functions_before),
                        expected = y * law_.columns, mean = expected.middleCols(1, functions_after);
  sums_.count += static_cast<double>(held_);
  sums_.joint.noalias() += f.transpose() * g;
  sums_.before.noalias() += y.transpose() * g;
  pairs_.noalias() +=
      (expected * products_.transpose() - products_of_columns(mean)).transpose() * products_of_columns(g);
  const Eigen::MatrixXd each = row_products(f.rightCols(functions_after) - mean, g);
  sums_.observed.noalias() += each.transpose() * each;
  held_ = 0;
}

const transition_sums& transition_moments::sums() {
  flush();
  for (Eigen::Index a = 0; a < all_tests; ++a)
    for (Eigen::Index b = 0; b < all_tests; ++b)
      sums_.variance(a, b) = pairs_(pair_index(a % functions_after, b % functions_after),
                                    pair_index(a / functions_after, b / functions_after));
  return sums_;
}

}  // namespace polhode
