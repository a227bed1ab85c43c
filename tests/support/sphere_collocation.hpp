// SPDX-License-Identifier: Apache-2.0
// A diffusion on the sphere by Fourier collocation in colatitude and longitude: no harmonics, no projection.
//
//   generator  b . grad + 1/2 sum_i (V_i . grad)^2,   V_i = x cross sigma_i,   b tangent
//
// Colatitudes (j + 1/2) pi / n, n odd, longitudes pi k / n; beyond a pole f goes on at the longitude half a turn on.
// Source: Trefethen, Spectral Methods in MATLAB (2000), chapter 11. The chequered grid function, which no derivative
// sees, is damped.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>

#include "sphere/harmonics/harmonics.hpp"

namespace polhode::test {

using field = std::function<Eigen::Vector3d(const Eigen::Vector3d& x)>;
using function_on_sphere = std::function<double(const Eigen::Vector3d& x)>;

class sphere_collocation {
 public:
  sphere_collocation(int n, const field& drift, const Eigen::Matrix3d& covariance);

  /// E[f] at a time, from one start.
  double expectation(const function_on_sphere& f, const Eigen::Vector3d& start, double time) const;
  struct rounded_mean {
    double value, rounding;
  };
  /// Poisson's equation A u = f - m with u of mean zero. rounding: of A u, as its entries and sums are rounded.
  rounded_mean mean_and_rounding(const function_on_sphere& f) const;
  double mean(const function_on_sphere& f) const { return mean_and_rounding(f).value; }
  /// The second largest real part of an eigenvalue, with the sign changed.
  double gap() const;

 private:
  Eigen::Index at(int j, int k) const { return 2 * n_ * j + k % (2 * n_); }
  double colatitude(int j) const { return (j + 0.5) * std::numbers::pi / n_; }
  double longitude(int k) const { return k * std::numbers::pi / n_; }
  static Eigen::Vector3d direction(double colatitude, double longitude) {
    const double s = std::sin(colatitude);
    return {s * std::cos(longitude), s * std::sin(longitude), std::cos(colatitude)};
  }
  /// Derivative at one of 2 n points around a circle of the trigonometric polynomial through them, by that `apart` on.
  double circle_derivative(int apart) const;
  /// Its value at an angle off that point.
  double circle_value(double angle) const;

  sparse_matrix along(const field& v) const;
  Eigen::VectorXd values(const function_on_sphere& f) const;
  Eigen::VectorXd weights_at(const Eigen::Vector3d& x) const;

  int n_;
  points_on_sphere points_;
  Eigen::MatrixXd a_;
};

/// x = Pi / c: x' = c x cross (K x + theta c x cross K x).
field drift_of(const sphere_problem&);

}  // namespace polhode::test
