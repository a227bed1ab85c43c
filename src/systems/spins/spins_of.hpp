// SPDX-License-Identifier: Apache-2.0
// The spins of a scene, in either form of them.
#pragma once

#include <Eigen/Core>
#include <utility>

#include "problem/drives.hpp"
#include "problem/vectors.hpp"
#include "reports/model/scene.hpp"

namespace polhode {

inline Eigen::MatrixXd matrix_of(const report::number_rows& rows) {
  const auto n = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd out(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    out.row(i) = Eigen::Map<const Eigen::RowVectorXd>(rows[static_cast<std::size_t>(i)].data(), n);
  return out;
}

template <class System, class Noise>
System spins_of(const report::scene& s, Noise noise) {
  return {matrix_of(s.vectors("quadratic")), three(s.vector("field")), matrix_of(s.vectors("exchange")),
          dissipation_of(s), std::move(noise)};
}

}  // namespace polhode
