// SPDX-License-Identifier: Apache-2.0
// Eigen's products and its LU, compiled once per instruction set: elsewhere Eigen has the registers of x86-64 alone.
#pragma once

#include <Eigen/Core>

#include "platform/isa_entry.hpp"

namespace polhode {

/// c += a b.
void add_product(const Eigen::Ref<const Eigen::MatrixXd>& a, const Eigen::Ref<const Eigen::MatrixXd>& b,
                 Eigen::Ref<Eigen::MatrixXd> c);

/// c += a^T b.
void add_transposed_product(const Eigen::Ref<const Eigen::MatrixXd>& a, const Eigen::Ref<const Eigen::MatrixXd>& b,
                            Eigen::Ref<Eigen::MatrixXd> c);

/// x with x a = b, by LU with partial pivots.
Eigen::RowVectorXd solve_from_left(const Eigen::Ref<const Eigen::MatrixXd>& a, const Eigen::RowVectorXd& b);

/// law T = law for T 1 = 1, the first function of the basis being a constant: of a given first component.
Eigen::RowVectorXd invariant_law(const Eigen::MatrixXd& transfer, double first);

/// x with a x = b, by the same.
Eigen::MatrixXd solution_of(const Eigen::Ref<const Eigen::MatrixXd>& a, const Eigen::Ref<const Eigen::MatrixXd>& b);

/// a^-1 by the same: for many right sides that come one after the other.
Eigen::MatrixXd inverse_of(const Eigen::Ref<const Eigen::MatrixXd>& a);

/// What the entries take: a matrix by columns, and c += a b or c += a^T b.
struct dense_columns {
  double* at;
  Eigen::Index rows, columns, stride;
};
struct dense_product {
  dense_columns a, b, c;
  bool transposed;
};

}  // namespace polhode

POLHODE_DECLARE_ENTRIES(polhode_add_product_, const polhode::dense_product&);
POLHODE_DECLARE_ENTRIES(polhode_solve_, const polhode::dense_columns&, const polhode::dense_columns& right_sides);
