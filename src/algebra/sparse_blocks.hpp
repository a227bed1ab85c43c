// SPDX-License-Identifier: Apache-2.0
// A sparse operator taken apart into the blocks that do not talk to each other, and its invariant vector.
#pragma once

#include <Eigen/SparseCore>
#include <optional>
#include <vector>

namespace polhode {

using sparse_matrix = Eigen::SparseMatrix<double>;
using index_set = std::vector<int>;  ///< increasing

/// The finest partition of the indices under which the matrix is block diagonal, ordered by smallest index. Finds every
/// symmetry that the basis is adapted to, without being told of it.
std::vector<index_set> connected_blocks(const sparse_matrix& a);

/// All blocks that hold an index where the vector is not zero.
index_set blocks_of(const sparse_matrix& a, const Eigen::VectorXd& vector);

sparse_matrix submatrix(const sparse_matrix& a, const index_set& indices);
sparse_matrix columns_of(const sparse_matrix& a, const index_set& columns);

/// nu with nu A = 0 and nu_0 = 1, for an A whose column 0 vanishes (A 1 = 0, the constant function being the first of
/// the basis), inside the block of index 0. Nothing if A is singular beyond that, or that block has more than `most`
/// indices.
std::optional<Eigen::VectorXd> left_null_vector(const sparse_matrix& a, int most);

}  // namespace polhode
