#include "experiments/shell_basis.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ensemble/dense_algebra.hpp"

namespace polhode {
namespace {

double up(int l, int m) { return std::sqrt((double(l) * l - double(m) * m) / (4.0 * l * l - 1)); }

/// P_mm over sin^m, then a and b of P_{l+1,m} = a z P_lm - b P_{l-1,m}.
std::vector<double> recurrence_of(int degree) {
  std::vector<double> out;
  double highest = std::sqrt(0.25 / std::numbers::pi);
  for (int m = 0; m <= degree; ++m) {
    if (m > 0) highest *= std::sqrt((2 * m + 1.0) / (2 * m)) * (m == 1 ? std::numbers::sqrt2 : 1);
    out.push_back(highest);
    for (int l = m; l <= degree; ++l) {
      out.push_back(1 / up(l + 1, m));
      out.push_back(l > m ? up(l, m) / up(l + 1, m) : 0);
    }
  }
  return out;
}

}  // namespace

shell_basis::shell_basis(int degree, int radial, const shell& s)
    : degree_(degree),
      radial_(radial),
      middle_((s.least + s.greatest) / 2),
      half_((s.greatest - s.least) / 2),
      recurrence_(recurrence_of(degree)) {
  const sphere_rule rule = sphere_quadrature(2 * degree + 2);
  duals_ = rule.weights.asDiagonal() * harmonics(rule.points, degree);
  const auto directions = rule.points.rows();
  points_.resize(directions * radial, 3);
  for (int i = 0; i < radial; ++i)
    points_.middleRows(i * directions, directions) = (middle_ + half_ * node(i)) * rule.points;
}

double shell_basis::node(int i) const { return std::cos(std::numbers::pi * (i + 0.5) / radial_); }

Eigen::VectorXd shell_basis::chebyshev(double t) const {
  const double angle = std::acos(std::clamp(t, -1.0, 1.0));
  return Eigen::VectorXd::NullaryExpr(radial_,
                                      [&](Eigen::Index k) { return std::cos(static_cast<double>(k) * angle); });
}

Eigen::RowVectorXd shell_basis::at(const Eigen::Vector3d& pi) const {
  const Eigen::VectorXd radials = chebyshev(radial_ == 1 ? 0 : (pi.norm() - middle_) / half_);
  return (radials * harmonics_at(pi.normalized(), degree_).transpose()).reshaped().transpose();
}

// First the directions of each radius, then the radii: T_k are orthogonal over the nodes.
Eigen::MatrixXd shell_basis::coefficients(const Eigen::MatrixXd& values) const {
  const auto directions = duals_.rows(), harmonic = duals_.cols();
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(size(), values.cols()), part(harmonic, values.cols());
  for (int i = 0; i < radial_; ++i) {
    part.setZero();
    add_transposed_product(duals_, values.middleRows(i * directions, directions), part);
    const Eigen::VectorXd radials = chebyshev(node(i));
    for (int k = 0; k < radial_; ++k)
      out(Eigen::seqN(k, harmonic, radial_), Eigen::all) += (k == 0 ? 1.0 : 2.0) / radial_ * radials[k] * part;
  }
  return out;
}

Eigen::VectorXd shell_basis::coefficients(const sphere_function& f) const {
  Eigen::VectorXd values(points_.rows());
  for (Eigen::Index i = 0; i < points_.rows(); ++i) values[i] = f(points_.row(i).transpose());
  return coefficients(Eigen::MatrixXd(values));
}

}  // namespace polhode
