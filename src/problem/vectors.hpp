// SPDX-License-Identifier: Apache-2.0
// States of any dimension, and matrices by their rows.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <span>

#include "reports/model/scene.hpp"

namespace polhode {

inline double length(std::span<const double> a) {
  double square = 0;
  for (const double x : a) square += x * x;
  return std::sqrt(square);
}

inline double distance(std::span<const double> a, std::span<const double> b) {
  double square = 0;
  for (std::size_t i = 0; i < a.size(); ++i) square += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(square);
}

/// The first three components.
inline std::array<double, 3> three(std::span<const double> a) { return {a[0], a[1], a[2]}; }

inline Eigen::MatrixXd matrix_of(const report::number_rows& rows) {
  const auto n = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd out(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    out.row(i) = Eigen::Map<const Eigen::RowVectorXd>(rows[static_cast<std::size_t>(i)].data(), n);
  return out;
}

}  // namespace polhode
