// SPDX-License-Identifier: Apache-2.0
#include "algebra/dense_algebra.hpp"

#include "platform/isa_entry.hpp"

namespace polhode {
namespace {

using matrix = Eigen::Ref<const Eigen::MatrixXd>;

/// What is const in `a` stays so.
dense_columns columns_of(const matrix& a) {
  return {const_cast<double*>(a.data()), a.rows(), a.cols(), a.outerStride()};
}

void add(const matrix& a, const matrix& b, Eigen::Ref<Eigen::MatrixXd>& c, bool transposed) {
  by_isa(POLHODE_ENTRIES(polhode_add_product_))({columns_of(a), columns_of(b), columns_of(c), transposed});
}

}  // namespace

void add_product(const matrix& a, const matrix& b, Eigen::Ref<Eigen::MatrixXd> c) { add(a, b, c, false); }

void add_transposed_product(const matrix& a, const matrix& b, Eigen::Ref<Eigen::MatrixXd> c) { add(a, b, c, true); }

Eigen::RowVectorXd solve_from_left(const matrix& a, const Eigen::RowVectorXd& b) {
  Eigen::RowVectorXd x = b;
  by_isa(POLHODE_ENTRIES(polhode_solve_))(columns_of(a), {x.data(), x.size(), 1, x.size()});
  return x;
}

// law (T - 1) = 0 with T 1 = 1: the first column is empty, and the first component is given.
Eigen::RowVectorXd invariant_law(const Eigen::MatrixXd& transfer, double first) {
  const auto n = transfer.rows() - 1;
  const Eigen::MatrixXd rest = transfer.bottomRightCorner(n, n) - Eigen::MatrixXd::Identity(n, n);
  Eigen::RowVectorXd law(n + 1);
  law << first, solve_from_left(rest, -first * transfer.row(0).tail(n));
  return law;
}

Eigen::MatrixXd solution_of(const matrix& a, const matrix& b) {
  const Eigen::MatrixXd transposed = a.transpose();
  Eigen::MatrixXd x = b;
  by_isa(POLHODE_ENTRIES(polhode_solve_))(columns_of(transposed), columns_of(x));
  return x;
}

Eigen::MatrixXd inverse_of(const matrix& a) {
  Eigen::MatrixXd transposed = Eigen::MatrixXd::Identity(a.rows(), a.rows());
  by_isa(POLHODE_ENTRIES(polhode_solve_))(columns_of(a), columns_of(transposed));
  return transposed.transpose();
}

}  // namespace polhode
