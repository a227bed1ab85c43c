// SPDX-License-Identifier: Apache-2.0
#include "algebra/krylov_space.hpp"

#include <algorithm>

#include "algebra/decompositions.hpp"

namespace polhode {
namespace {

constexpr double exhausted = 1e-14;  // of |A b|: nothing is left to span

}  // namespace

krylov_space::krylov_space(linear_map map, const Eigen::VectorXd& start, Eigen::Index most)
    : map_(std::move(map)),
      basis_(start.size(), std::min(most, start.size()) + 1),
      projected_(Eigen::MatrixXd::Zero(basis_.cols(), basis_.cols() - 1)) {
  basis_.col(0) = start.normalized();
}

void krylov_space::grow(Eigen::Index dimension) {
  while (size_ < std::min(dimension, projected_.cols()) && !closed_) {
    Eigen::VectorXd next = map_(basis_.col(size_));
    if (size_ == 0) scale_ = next.norm();
    for (int pass = 0; pass < 2; ++pass) {  // twice is enough (Giraud et al. 2005)
      const Eigen::VectorXd along = basis_.leftCols(size_ + 1).transpose() * next;
      next -= basis_.leftCols(size_ + 1) * along;
      projected_.col(size_).head(size_ + 1) += along;
    }
    const double rest = next.norm();
    ++size_;
    closed_ = !(rest > exhausted * scale_);
    if (closed_) break;
    projected_(size_, size_ - 1) = rest;
    basis_.col(size_) = next / rest;
  }
}

std::vector<ritz_pair> krylov_space::ritz_pairs() const {
  if (!projected_.allFinite()) return {};
  const auto [values, vectors] = eigenpairs_of(projected());
  std::vector<ritz_pair> out;
  for (Eigen::Index i = 0; i < size_; ++i)
    out.push_back({values[i], projected_(size_, size_ - 1) * std::abs(vectors(size_ - 1, i)), vectors.col(i)});
  return out;
}

}  // namespace polhode
