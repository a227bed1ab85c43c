// The Gibbs law of the rigid body on the momentum sphere, exactly: density exp(-beta h) on |Pi| = c.
#pragma once

#include <array>
#include <memory>
#include <vector>

namespace polhode {

/// h has density proportional to exp(-beta h) tau(h), tau the period of the free motion at that energy (the area
/// between two energies on the sphere is c times the integral of the period), a complete elliptic integral; the mean of
/// Pi_k^2 on an orbit is one too. beta = 2 theta / sigma^2 >= 0. Not all moments of inertia may be equal (then h is
/// constant). Accurate to about 1e-11 in moments and 1e-6 in the distribution function.
class gibbs_law {
 public:
  gibbs_law(const std::array<double, 3>& inertia, double c, double beta);
  ~gibbs_law();
  gibbs_law(gibbs_law&&) noexcept;

  double least_energy() const { return least_; }
  double greatest_energy() const { return greatest_; }
  double mean_energy() const { return mean_; }
  double energy_variance() const { return variance_; }
  double mean_square(int axis) const { return squares_[static_cast<std::size_t>(axis)]; }  ///< E[Pi_axis^2]
  double energy_cdf(double h) const;

 private:
  struct piece;  // the law between two critical energies
  double least_, greatest_, mean_ = 0, variance_ = 0;
  std::array<double, 3> squares_{};
  std::vector<piece> pieces_;
};

}  // namespace polhode
