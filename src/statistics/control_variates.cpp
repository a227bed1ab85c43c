#include "statistics/control_variates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algebra/decompositions.hpp"
#include "statistics/distributions.hpp"

namespace polhode {
namespace {

/// Least squares of y on the controls and a constant, which is not returned.
Eigen::VectorXd coefficients(const Eigen::VectorXd& y, const Eigen::MatrixXd& controls) {
  Eigen::MatrixXd design(y.size(), controls.cols() + 1);
  design << controls, Eigen::VectorXd::Ones(y.size());
  const Eigen::MatrixXd normal = design.transpose() * design;
  const Eigen::VectorXd right = design.transpose() * y;
  return (pseudo_inverse(normal) * right).head(controls.cols());
}

}  // namespace

Eigen::VectorXd controlled(const Eigen::VectorXd& y, const Eigen::MatrixXd& controls) {
  const Eigen::Index first = y.size() / 2, second = y.size() - first;
  Eigen::VectorXd out = y;
  out.head(first) -= controls.topRows(first) * coefficients(y.tail(second), controls.bottomRows(second));
  out.tail(second) -= controls.bottomRows(second) * coefficients(y.head(first), controls.topRows(first));
  return out;
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
