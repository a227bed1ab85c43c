#include "sphere/observables.hpp"

#include <cmath>

namespace polhode {
namespace {

constexpr int degree = 8;
constexpr double least = 1e-290;

}  // namespace

std::optional<double> unit_of(const sphere_problem& problem, const sphere_function& f) {
  const Eigen::VectorXd c =
      harmonic_coefficients([&](const Eigen::Vector3d& x) { return f(problem.radius * x); }, degree);
  const double largest = c.cwiseAbs().maxCoeff();
  if (!c.allFinite() || largest < least) return std::nullopt;
  return std::exp2(std::ilogb(largest));
}

}  // namespace polhode
