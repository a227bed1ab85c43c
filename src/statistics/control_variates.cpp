#include "statistics/control_variates.hpp"

#include <Eigen/QR>

namespace polhode {
namespace {

/// Least squares of y on the controls and a constant, which is not returned.
Eigen::VectorXd coefficients(const Eigen::VectorXd& y, const Eigen::MatrixXd& controls) {
  Eigen::MatrixXd design(y.size(), controls.cols() + 1);
  design << controls, Eigen::VectorXd::Ones(y.size());
  const Eigen::MatrixXd normal = design.transpose() * design;
  const Eigen::VectorXd right = design.transpose() * y;
  return Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(normal).solve(right).head(controls.cols());
}

}  // namespace

Eigen::VectorXd controlled(const Eigen::VectorXd& y, const Eigen::MatrixXd& controls) {
  const Eigen::Index first = y.size() / 2, second = y.size() - first;
  Eigen::VectorXd out = y;
  out.head(first) -= controls.topRows(first) * coefficients(y.tail(second), controls.bottomRows(second));
  out.tail(second) -= controls.bottomRows(second) * coefficients(y.head(first), controls.topRows(first));
  return out;
}

}  // namespace polhode
