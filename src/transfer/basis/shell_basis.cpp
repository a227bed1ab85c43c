// SPDX-License-Identifier: Apache-2.0
#include "transfer/basis/shell_basis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <numeric>

#include "algebra/dense_algebra.hpp"
#include "transfer/points/turned_quadrature.hpp"

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

/// How Y_lm changes under the half turns about axes 3 and 1.
std::size_t class_of(int l, int m) {
  const bool odd_about_3 = m % 2 != 0, odd_about_1 = (l + m) % 2 != 0;
  return (odd_about_3 ? 2u : 0u) + (odd_about_1 != (m < 0) ? 1u : 0u);
}

/// [class]: harmonics up to the degree.
std::array<std::vector<int>, 4> harmonics_by_class(int degree) {
  std::array<std::vector<int>, 4> out;
  for (int l = 0; l <= degree; ++l)
    for (int m = -l; m <= l; ++m) out[class_of(l, m)].push_back(harmonic_index(l, m));
  return out;
}

/// Columns k radial ... of those harmonics.
std::vector<int> functions_of(const std::vector<int>& harmonics, int radial) {
  std::vector<int> out;
  for (const int h : harmonics)
    for (int k = 0; k < radial; ++k) out.push_back(h * radial + k);
  return out;
}

/// Those of degrees that operators have (transfer_refine.cpp) are kept: 100 MB together.
std::shared_ptr<const shell_basis::tables> tables_of(int degree) {
  constexpr int most_kept = 40;
  static std::mutex one_at_a_time;
  static std::map<int, std::shared_ptr<const shell_basis::tables>> kept;
  if (degree > most_kept) return std::make_shared<shell_basis::tables>(degree);
  const std::lock_guard lock(one_at_a_time);
  auto& found = kept[degree];
  if (!found) found = std::make_shared<shell_basis::tables>(degree);
  return found;
}

}  // namespace

shell_basis::tables::tables(int degree)
    : rule(turned_quadrature(2 * degree + 2)),
      duals(rule.weights.asDiagonal() * harmonics(rule.points, degree)),
      recurrence(recurrence_of(degree)) {}

shell_basis::shell_basis(int degree, int radial, const shell& s)
    : degree_(degree),
      radial_(radial),
      middle_((s.least + s.greatest) / 2),
      half_((s.greatest - s.least) / 2),
      tables_(tables_of(degree)) {
  const auto& directions = tables_->rule.points;
  points_.resize(directions.rows() * radial, 3);
  for (int i = 0; i < radial; ++i)
    points_.middleRows(i * directions.rows(), directions.rows()) = (middle_ + half_ * node(i)) * directions;
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
void shell_basis::add_radius(int i, const std::vector<int>& harmonics, const std::vector<int>& columns,
                             const Eigen::MatrixXd& part, Eigen::MatrixXd& out) const {
  const Eigen::VectorXd factors = chebyshev(node(i)) / radial_;
  for (std::size_t j = 0; j < columns.size(); ++j)
    for (std::size_t h = 0; h < harmonics.size(); ++h) {
      const double value = part(static_cast<Eigen::Index>(h), static_cast<Eigen::Index>(j));
      double* const at = &out(harmonics[h] * radial_, columns[j]);
      at[0] += factors[0] * value;
      for (int k = 1; k < radial_; ++k) at[k] += 2 * factors[k] * value;
    }
}

Eigen::MatrixXd shell_basis::coefficients(const Eigen::MatrixXd& values) const {
  const auto directions = duals().rows();
  std::vector<int> harmonics(static_cast<std::size_t>(duals().cols())),
      columns(static_cast<std::size_t>(values.cols()));
  std::iota(harmonics.begin(), harmonics.end(), 0);
  std::iota(columns.begin(), columns.end(), 0);
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(size(), values.cols()), part(duals().cols(), values.cols());
  for (int i = 0; i < radial_; ++i) {
    const auto some = values.middleRows(i * directions, directions);
    part.setZero();
    if (values.cols() < directions / 8)
      add_transposed_product(duals(), some, part);
    else
      add_by_rings(duals(), degree_, some, part);
    add_radius(i, harmonics, columns, part, out);
  }
  return out;
}

std::vector<std::vector<int>> shell_basis::classes() const {
  std::vector<std::vector<int>> out;
  for (const auto& harmonics : harmonics_by_class(degree_)) out.push_back(functions_of(harmonics, radial_));
  return out;
}

Eigen::Matrix<double, Eigen::Dynamic, 3> shell_basis::quarter() const {
  const auto directions = duals().rows(), count = directions / 4;
  Eigen::Matrix<double, Eigen::Dynamic, 3> out(count * radial_, 3);
  for (int i = 0; i < radial_; ++i) out.middleRows(i * count, count) = points_.middleRows(i * directions, count);
  return out;
}

// A product of two functions of one class is the same at a point and its images.
Eigen::MatrixXd shell_basis::coefficients_by_class(const Eigen::MatrixXd& values) const {
  const auto count = duals().rows() / 4;
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(size(), size());
  for (const auto& harmonics : harmonics_by_class(degree_)) {
    const auto columns = functions_of(harmonics, radial_);
    const Eigen::MatrixXd dual = 4 * duals()(Eigen::seqN(0, count), harmonics), some = values(Eigen::all, columns);
    Eigen::MatrixXd part(dual.cols(), some.cols());
    for (int i = 0; i < radial_; ++i) {
      part.setZero();
      add_transposed_product(dual, some.middleRows(i * count, count), part);
      add_radius(i, harmonics, columns, part, out);
    }
  }
  return out;
}

Eigen::VectorXd shell_basis::coefficients(const sphere_function& f) const {
  Eigen::VectorXd values(points_.rows());
  for (Eigen::Index i = 0; i < points_.rows(); ++i) values[i] = f(points_.row(i).transpose());
  return coefficients(Eigen::MatrixXd(values));
}

}  // namespace polhode
