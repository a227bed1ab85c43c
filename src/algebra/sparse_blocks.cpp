// SPDX-License-Identifier: Apache-2.0
#include "algebra/sparse_blocks.hpp"

#include <algorithm>
#include <numeric>

#include "algebra/decompositions.hpp"

namespace polhode {
namespace {

int root_of(std::vector<int>& parent, int i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

Eigen::VectorXd gathered(const Eigen::VectorXd& v, const index_set& indices) { return v(indices); }

}  // namespace

std::vector<index_set> connected_blocks(const sparse_matrix& a) {
  std::vector<int> parent(static_cast<std::size_t>(a.cols()));
  std::iota(parent.begin(), parent.end(), 0);
  for (int column = 0; column < a.outerSize(); ++column)
    for (sparse_matrix::InnerIterator entry(a, column); entry; ++entry) {
      const int one = root_of(parent, column), other = root_of(parent, static_cast<int>(entry.row()));
      parent[std::max(one, other)] = std::min(one, other);  // a root is the smallest of its block
    }
  std::vector<index_set> blocks;
  std::vector<std::size_t> block(parent.size());
  for (int i = 0; i < a.cols(); ++i) {
    const int root = root_of(parent, i);
    if (root == i) {
      block[i] = blocks.size();
      blocks.emplace_back();
    }
    blocks[block[root]].push_back(i);
  }
  return blocks;
}

index_set blocks_of(const sparse_matrix& a, const Eigen::VectorXd& vector) {
  index_set all;
  for (const index_set& block : connected_blocks(a))
    if ((gathered(vector, block).array() != 0).any()) all.insert(all.end(), block.begin(), block.end());
  std::ranges::sort(all);
  return all;
}

sparse_matrix submatrix(const sparse_matrix& a, const index_set& indices) {
  std::vector<int> place(static_cast<std::size_t>(a.rows()), -1);
  for (int k = 0; k < std::ssize(indices); ++k) place[indices[k]] = k;
  std::vector<Eigen::Triplet<double>> entries;
  for (int k = 0; k < std::ssize(indices); ++k)
    for (sparse_matrix::InnerIterator entry(a, indices[k]); entry; ++entry)
      if (place[entry.row()] >= 0) entries.emplace_back(place[entry.row()], k, entry.value());
  sparse_matrix part(std::ssize(indices), std::ssize(indices));
  part.setFromTriplets(entries.begin(), entries.end());
  return part;
}

sparse_matrix columns_of(const sparse_matrix& a, const index_set& columns) {
  sparse_matrix part(a.rows(), std::ssize(columns));
  part.reserve(a.nonZeros());  // a whole column at a time would move all that are there
  for (int k = 0; k < std::ssize(columns); ++k) {
    part.startVec(k);
    for (sparse_matrix::InnerIterator entry(a, columns[k]); entry; ++entry)
      part.insertBack(entry.row(), k) = entry.value();
  }
  part.finalize();
  return part;
}

std::optional<Eigen::VectorXd> left_null_vector(const sparse_matrix& a, int most) {
  Eigen::VectorXd nu = Eigen::VectorXd::Unit(a.rows(), 0);
  index_set rest = blocks_of(a, nu);
  if (std::ssize(rest) > most) return std::nullopt;
  rest.erase(rest.begin());
  if (rest.empty()) return nu;
  const sparse_matrix transposed = a.transpose();
  const Eigen::VectorXd forcing = gathered(-transposed.col(0), rest);
  Eigen::SparseLU<sparse_matrix> lu(submatrix(transposed, rest));
  if (lu.info() != Eigen::Success) return std::nullopt;
  const Eigen::VectorXd solved = lu.solve(forcing);  // SparseLU writes wrongly through an index view
  if (!solved.allFinite()) return std::nullopt;
  nu(rest) = solved;
  return nu;
}

}  // namespace polhode
