// Functions of momentum near a sphere as linear algebra: Chebyshev polynomials in the radius times spherical harmonics.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "references/kolmogorov.hpp"

namespace polhode {

/// Radii least <= |Pi| <= greatest, 0 < least. With radial = 1 the sphere |Pi| = least, greatest being the same.
struct shell {
  double least, greatest;
};

/// B_j = T_k(t) Y_lm(Pi / |Pi|), j = (l^2 + l + m) radial + k, t the radius, in [-1, 1] on the shell. Beyond,
/// functions go on as polynomials, and from most_outside half widths on they keep their value
/// (ensemble/basis_sums.hpp).
class shell_basis {
 public:
  shell_basis(int degree, int radial, const shell&);

  int size() const { return static_cast<int>(duals_.cols()) * radial_; }
  int degree() const { return degree_; }
  int radial() const { return radial_; }
  Eigen::RowVectorXd at(const Eigen::Vector3d& pi) const;

  /// Where functions are known by their values: for each Chebyshev radius all directions of the quadrature that is
  /// exact for products of two harmonics. A point a row.
  const Eigen::Matrix<double, Eigen::Dynamic, 3>& points() const { return points_; }
  /// Columns of values at the points into columns of coefficients: exact for functions in the span.
  Eigen::MatrixXd coefficients(const Eigen::MatrixXd& values) const;
  Eigen::VectorXd coefficients(const sphere_function& f) const;

  double middle() const { return middle_; }
  double half() const { return half_; }
  const std::vector<double>& recurrence() const { return recurrence_; }  ///< ensemble/basis_sums.hpp

 private:
  double node(int i) const;  ///< Chebyshev's, in (-1, 1)
  Eigen::VectorXd chebyshev(double t) const;

  int degree_, radial_;
  double middle_, half_;
  Eigen::MatrixXd duals_;  ///< direction x harmonic: weight times value
  Eigen::Matrix<double, Eigen::Dynamic, 3> points_;
  std::vector<double> recurrence_;
};

}  // namespace polhode
