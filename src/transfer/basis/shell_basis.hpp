// SPDX-License-Identifier: Apache-2.0
// Functions of momentum near a sphere as linear algebra: Chebyshev polynomials in the radius times spherical harmonics.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "sphere/harmonics/harmonics.hpp"
#include "sphere/sphere_problem.hpp"

namespace polhode {

/// Radii least <= |Pi| <= greatest, 0 < least. With radial = 1 the sphere |Pi| = least, greatest being the same.
struct shell {
  double least, greatest;
};

/// B_j = T_k(t) Y_lm(Pi / |Pi|), j = (l^2 + l + m) radial + k, t the radius, in [-1, 1] on the shell. Beyond,
/// functions go on as polynomials, and from most_outside half widths on they keep their value
/// (transfer/basis_sums.hpp).
class shell_basis {
 public:
  shell_basis(int degree, int radial, const shell&);

  int size() const { return static_cast<int>(duals().cols()) * radial_; }
  int degree() const { return degree_; }
  int radial() const { return radial_; }
  Eigen::RowVectorXd at(const Eigen::Vector3d& pi) const;

  /// Where functions are known by their values: for each Chebyshev radius all directions of the quadrature that is
  /// exact for products of two harmonics. A point a row.
  const Eigen::Matrix<double, Eigen::Dynamic, 3>& points() const { return points_; }
  /// Columns of values at the points into columns of coefficients: exact for functions in the span.
  Eigen::MatrixXd coefficients(const Eigen::MatrixXd& values) const;

  /// By how they change under the half turns of half_turns.hpp about axes 3 and 1: functions that keep their sign under
  /// both come first. Increasing; together all functions.
  std::vector<std::vector<int>> classes() const;
  /// The points of which all are images under the half turns, for each radius.
  Eigen::Matrix<double, Eigen::Dynamic, 3> quarter() const;
  /// The same of functions of which column j changes under the half turns as B_j does: from their values at quarter().
  Eigen::MatrixXd coefficients_by_class(const Eigen::MatrixXd& values_on_quarter) const;
  Eigen::VectorXd coefficients(const sphere_function& f) const;

  double middle() const { return middle_; }
  double half() const { return half_; }
  const std::vector<double>& recurrence() const { return tables_->recurrence; }  ///< transfer/basis_sums.hpp

  /// What all bases of a degree have in common.
  struct tables {
    sphere_rule rule;
    Eigen::MatrixXd duals;  ///< direction x harmonic: weight times value; those of a quarter, then their images
    std::vector<double> recurrence;
    explicit tables(int degree);
  };

 private:
  const Eigen::MatrixXd& duals() const { return tables_->duals; }
  double node(int i) const;  ///< Chebyshev's, in (-1, 1)
  Eigen::VectorXd chebyshev(double t) const;
  void add_radius(int i, const std::vector<int>& harmonics, const std::vector<int>& columns,
                  const Eigen::MatrixXd& part, Eigen::MatrixXd& out) const;

  int degree_, radial_;
  double middle_, half_;
  std::shared_ptr<const tables> tables_;
  Eigen::Matrix<double, Eigen::Dynamic, 3> points_;
};

}  // namespace polhode
