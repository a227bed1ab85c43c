// SPDX-License-Identifier: Apache-2.0
// The Gibbs law of the rigid body on the momentum sphere, exactly: density exp(-beta h) on |Pi| = c.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "sphere/sphere_problem.hpp"

namespace polhode {

/// beta = 2 theta / sigma^2 >= 0. Moments: a Bingham law (sphere/closed_forms/gibbs_moments.hpp), each as certain as it
/// says. Distribution of h: density exp(-beta h) tau(h), tau the period of the free motion at that energy (the area
/// between two energies on the sphere is c times the integral of the period), a complete elliptic integral; accurate to
/// about 1e-6, of a cold law to 1e-4. Not all moments of inertia may be equal (then h is constant).
class gibbs_law {
 public:
  gibbs_law(const std::array<double, 3>& inertia, double c, double beta);
  /// Of any h, under isotropic noise: sums over some 10^5 points of the sphere. Moments are uncertain by what half as
  /// many in a direction change, the distribution by about 1e-4, or by the mass of a ring of points at an extreme of h.
  static gibbs_law by_quadrature(const sphere_problem&);
  ~gibbs_law();
  gibbs_law(gibbs_law&&) noexcept;

  double least_energy() const { return least_; }
  double greatest_energy() const { return greatest_; }
  double mean_energy() const { return least_ + excess_; }
  double excess_energy() const { return excess_; }  ///< mean above the least: all digits under weak noise too
  double energy_variance() const { return variance_; }
  double mean_square(int axis) const { return squares_[static_cast<std::size_t>(axis)]; }  ///< E[Pi_axis^2]
  double energy_cdf(double h) const;

  /// Of mean_energy, excess_energy and each mean_square, relative to its own size.
  double relative_uncertainty() const { return relative_uncertainty_; }

 private:
  struct piece;  // the law between two energies
  gibbs_law() = default;
  void add_piece(const std::array<double, 3>& inertia, double beta, double low, double high, bool round_last);

  double least_ = 0, greatest_ = 0, excess_ = 0, variance_ = 0, relative_uncertainty_ = 0;
  std::array<double, 3> squares_{};
  std::array<double, 3> critical_{};  // energies of the axes, decreasing
  std::vector<piece> pieces_;
};

}  // namespace polhode
