// SPDX-License-Identifier: Apache-2.0
#include "support/sphere_collocation.hpp"

#include <Eigen/SparseCore>

#include "algebra/decompositions.hpp"
#include "support/dense.hpp"

namespace polhode::test {

sphere_collocation::sphere_collocation(int n, const field& drift, const Eigen::Matrix3d& covariance)
    : n_(n), points_(2 * n * n, 3), a_(2 * n * n, 2 * n * n) {
  for (int j = 0; j < n; ++j)
    for (int k = 0; k < 2 * n; ++k) points_.row(at(j, k)) = direction(colatitude(j), longitude(k));
  sparse_matrix whole = along(drift);
  const auto [values, axes] = symmetric_eigenpairs_of(covariance);
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d sigma = std::sqrt(std::max(0.0, values[i])) * axes.col(i);
    if (sigma.isZero(0)) continue;
    const sparse_matrix v = along([&](const Eigen::Vector3d& x) { return x.cross(sigma).eval(); });
    whole += 0.5 * sparse_matrix(v * v);
  }
  a_ = whole;
  Eigen::VectorXd chequered(a_.rows());
  for (int j = 0; j < n; ++j)
    for (int k = 0; k < 2 * n; ++k) chequered[at(j, k)] = (j + k) % 2 == 0 ? 1 : -1;
  a_ -= a_.norm() / double(a_.rows()) * chequered * chequered.transpose();
}

double sphere_collocation::expectation(const function_on_sphere& f, const Eigen::Vector3d& start, double time) const {
  return weights_at(start).dot(exponential_of(time * a_) * values(f));
}

sphere_collocation::rounded_mean sphere_collocation::mean_and_rounding(const function_on_sphere& f) const {
  Eigen::MatrixXd bordered = Eigen::MatrixXd::Zero(a_.rows() + 1, a_.rows() + 1);
  const Eigen::Index n = a_.rows();
  const double unit = a_.norm();
  bordered.topLeftCorner(n, n) = a_ / unit;
  bordered.topRightCorner(n, 1).setOnes();
  bordered.bottomLeftCorner(1, n).setConstant(1 / double(n));
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n + 1);
  right.head(n) = values(f);
  const Eigen::VectorXd solved = solution_of(bordered, right);
  const Eigen::VectorXd sizes = bordered.topLeftCorner(n, n).cwiseAbs() * solved.head(n).cwiseAbs();
  return {solved[n], 1e-16 * sizes.maxCoeff()};
}

double sphere_collocation::gap() const {
  Eigen::VectorXd rates = eigenvalues_of(a_).real();
  std::ranges::sort(rates, std::greater());
  return -rates[1];
}

double sphere_collocation::circle_derivative(int apart) const {
  if (apart % (2 * n_) == 0) return 0;
  return 0.5 * (apart % 2 == 0 ? 1 : -1) / std::tan(apart * std::numbers::pi / (2 * n_));
}

double sphere_collocation::circle_value(double angle) const {
  if (std::fabs(std::sin(angle / 2)) < 1e-14) return 1;
  return std::sin(n_ * angle) / (2 * n_ * std::tan(angle / 2));
}

sparse_matrix sphere_collocation::along(const field& v) const {
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < n_; ++j)
    for (int k = 0; k < 2 * n_; ++k) {
      const double t = colatitude(j), p = longitude(k);
      const Eigen::Vector3d here = v(points_.row(at(j, k)));
      const double south = here.dot(direction(t + std::numbers::pi / 2, p));
      const double east = here.dot(Eigen::Vector3d(-std::sin(p), std::cos(p), 0)) / std::sin(t);
      for (int l = 0; l < n_; ++l) {  // the circle through both poles
        entries.emplace_back(at(j, k), at(l, k), south * circle_derivative(j - l));
        entries.emplace_back(at(j, k), at(l, k + n_), south * circle_derivative(j + l + 1));
      }
      for (int l = 0; l < 2 * n_; ++l) entries.emplace_back(at(j, k), at(j, l), east * circle_derivative(k - l));
    }
  sparse_matrix out(points_.rows(), points_.rows());
  out.setFromTriplets(entries.begin(), entries.end());
  return out;
}

Eigen::VectorXd sphere_collocation::values(const function_on_sphere& f) const {
  return Eigen::VectorXd::NullaryExpr(points_.rows(), [&](Eigen::Index i) { return f(points_.row(i)); });
}

Eigen::VectorXd sphere_collocation::weights_at(const Eigen::Vector3d& x) const {
  const double t = std::atan2(std::hypot(x[0], x[1]), x[2]), p = std::atan2(x[1], x[0]);
  Eigen::VectorXd out = Eigen::VectorXd::Zero(points_.rows());
  for (int j = 0; j < n_; ++j)
    for (int k = 0; k < 2 * n_; ++k) {
      const double east = circle_value(p - longitude(k));
      out[at(j, k)] += circle_value(t - colatitude(j)) * east;
      out[at(j, k + n_)] += circle_value(t + colatitude(j)) * east;
    }
  return out;
}

field drift_of(const sphere_problem& p) {
  return [c = p.radius, theta = p.damping,
          k = Eigen::Array3d(p.quadratic.diagonal())](const Eigen::Vector3d& x) -> Eigen::Vector3d {
    const Eigen::Vector3d rate = c * (k * x.array()).matrix();
    return x.cross(rate + theta * c * x.cross(rate));
  };
}

}  // namespace polhode::test
