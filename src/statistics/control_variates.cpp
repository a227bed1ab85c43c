// SPDX-License-Identifier: Apache-2.0
#include "statistics/control_variates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algebra/decompositions.hpp"
#include "statistics/distributions.hpp"

namespace polhode {
namespace {

/// Least squares of each column of y on the controls and a constant, which is not returned.
Eigen::MatrixXd coefficients(const Eigen::MatrixXd& y, const Eigen::MatrixXd& controls) {
  Eigen::MatrixXd design(y.rows(), controls.cols() + 1);
  design << controls, Eigen::VectorXd::Ones(y.rows());
  const Eigen::MatrixXd normal = design.transpose() * design;
  const Eigen::MatrixXd right = design.transpose() * y;
  return (pseudo_inverse(normal) * right).topRows(controls.cols());
}

}  // namespace

Eigen::MatrixXd all_controlled(const Eigen::MatrixXd& y, const Eigen::MatrixXd& controls) {
  const Eigen::Index first = y.rows() / 2, second = y.rows() - first;
  Eigen::MatrixXd out = y;
  out.topRows(first) -= controls.topRows(first) * coefficients(y.bottomRows(second), controls.bottomRows(second));
  out.bottomRows(second) -= controls.bottomRows(second) * coefficients(y.topRows(first), controls.topRows(first));
  return out;
}

Eigen::VectorXd controlled(const Eigen::VectorXd& y, const Eigen::MatrixXd& controls) {
  return all_controlled(y, controls);
}

control_means means_of_controls(const Eigen::MatrixXd& controls) {
  const auto n = static_cast<double>(controls.rows());
  control_means out;
  for (Eigen::Index i = 0; i < controls.cols(); ++i) {
    const auto y = controls.col(i);
    const double mean = y.mean(), error = std::sqrt((y.array() - mean).square().sum() / (n - 1) / n);
    if (!std::isfinite(error)) return {out.count, std::numeric_limits<double>::quiet_NaN()};
    if (error == 0) continue;
    ++out.count;
    const double deviate = normal_deviate(student_t_tail(std::fabs(mean / error), n - 1));
    if (deviate > std::fabs(out.largest)) out.largest = std::copysign(deviate, mean);
  }
  return out;
}

}  // namespace polhode
