// SPDX-License-Identifier: Apache-2.0
// Krylov spaces of a linear map.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <functional>
#include <vector>

namespace polhode {

/// An eigenpair of a map on its Krylov space.
struct ritz_pair {
  std::complex<double> value;
  double remainder;         ///< |A v - value v|, v of norm one
  Eigen::VectorXcd vector;  ///< in coordinates of the basis, of norm one
};

/// An orthonormal basis V of span{b, A b, A^2 b, ...}, grown on demand (Arnoldi); H = V^T A V.
class krylov_space {
 public:
  using linear_map = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

  /// `most`: the largest dimension; that of the whole space at most.
  krylov_space(linear_map, const Eigen::VectorXd& start, Eigen::Index most);

  /// To that dimension, or to where A adds nothing more: the space is closed then.
  void grow(Eigen::Index dimension);
  Eigen::Index size() const { return size_; }
  bool closed() const { return closed_; }
  double scale() const { return scale_; }  ///< |A b| / |b|
  auto basis() const { return basis_.leftCols(size_); }
  auto projected() const { return projected_.topLeftCorner(size_, size_); }  ///< H

  /// All of them; none where H is not finite.
  std::vector<ritz_pair> ritz_pairs() const;

 private:
  linear_map map_;
  Eigen::MatrixXd basis_, projected_;
  Eigen::Index size_ = 0;
  double scale_ = 0;
  bool closed_ = false;
};

}  // namespace polhode
