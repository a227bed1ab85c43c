// SPDX-License-Identifier: Apache-2.0
#include "ensemble/coadjoint_matrices.hpp"

#include <algorithm>

namespace polhode {
namespace {

/// Whether d/dt of the square of those components vanishes at every momentum.
bool keeps_length_of(const std::vector<Eigen::MatrixXd>& coadjoint, Eigen::Index first, Eigen::Index count) {
  return std::ranges::all_of(coadjoint, [&](const Eigen::MatrixXd& c) {
    Eigen::MatrixXd form = Eigen::MatrixXd::Zero(c.rows(), c.cols());
    form.middleRows(first, count) = c.middleRows(first, count);
    return (form + form.transpose()).isZero();
  });
}

}  // namespace

std::vector<Eigen::MatrixXd> coadjoint_matrices(const model& m) {
  const auto n = static_cast<std::size_t>(m.dimension());
  std::vector<Eigen::MatrixXd> out(n, Eigen::MatrixXd(m.dimension(), m.dimension()));
  std::vector<double> xi(n), mu(n);
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t j = 0; j < n; ++j) {
      std::ranges::fill(xi, 0.0);
      std::ranges::fill(mu, 0.0);
      xi[k] = mu[j] = 1;
      m.coadjoint(xi, mu, {out[k].col(static_cast<Eigen::Index>(j)).data(), n});
    }
  return out;
}

bool keeps_length(const model& m) { return keeps_length_of(coadjoint_matrices(m), 0, m.dimension()); }

std::optional<int> kept_vector(const model& m) {
  const auto coadjoint = coadjoint_matrices(m);
  for (int first = 0; first + 3 <= m.dimension(); first += 3)
    if (keeps_length_of(coadjoint, first, 3)) return first;
  return std::nullopt;
}

}  // namespace polhode
