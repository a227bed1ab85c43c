// SPDX-License-Identifier: Apache-2.0
#include "sphere/harmonics/angular_velocity.hpp"

namespace polhode {

polynomial rate_polynomial(const angular_velocity& v, int i) { return {.constant = v.b[i], .linear = v.a.row(i)}; }

// x_j (Ax + b)_k - x_k (Ax + b)_j, products of two coordinates collected.
polynomial cross_polynomial(const angular_velocity& v, int i) {
  const int j = (i + 1) % 3, k = (i + 2) % 3;
  polynomial out;
  out.linear[j] = v.b[k];
  out.linear[k] = -v.b[j];
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  products.row(j) = v.a.row(k);
  products.row(k) = -v.a.row(j);
  out.quadratic = (products + products.transpose()) / 2;
  return out;
}

sparse_matrix multiplying_by(const polynomial& p, const std::array<sparse_matrix, 3>& x) {
  sparse_matrix out(x[0].rows(), x[0].cols());
  if (p.constant != 0) {
    out.setIdentity();
    out *= p.constant;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (p.linear[long(i)] != 0) out += p.linear[long(i)] * x[i];
    for (std::size_t j = i; j < 3; ++j) {
      const double q = (i == j ? 1 : 2) * p.quadratic(long(i), long(j));
      if (q != 0) out += q * sparse_matrix(x[i] * x[j]);
    }
  }
  return out;
}

}  // namespace polhode
