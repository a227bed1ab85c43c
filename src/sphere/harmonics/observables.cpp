// SPDX-License-Identifier: Apache-2.0
#include "sphere/harmonics/observables.hpp"

#include <cmath>

#include "sphere/galerkin/poisson.hpp"
#include "sphere/harmonics/harmonics.hpp"

namespace polhode {
namespace {

constexpr int sizing_degree = 8;
constexpr double least_size = 1e-290;

Eigen::VectorXd all_coefficients(const sphere_problem& problem, const sphere_function& f, int degree) {
  return harmonic_coefficients([&](const Eigen::Vector3d& x) { return f(problem.radius * x); }, degree);
}

}  // namespace

Eigen::VectorXd observable_coefficients(const sphere_problem& problem, const sphere_function& f, int degree) {
  const Eigen::VectorXd c = all_coefficients(problem, f, degree);
  const double least = rounding_of_sums * c.norm();
  return c.unaryExpr([&](double x) { return std::fabs(x) < least ? 0 : x; });
}

cut_function cut_to(const sphere_problem& problem, const sphere_function& f, int degree) {
  const Eigen::VectorXd more = observable_coefficients(problem, f, degree + 2);
  const int count = harmonic_count(degree);
  return {more.head(count), harmonic_supremum(more.tail(more.size() - count), degree + 1)};
}

std::optional<double> unit_of(const sphere_problem& problem, const sphere_function& f) {
  return unit_of(all_coefficients(problem, f, sizing_degree));
}

std::optional<double> unit_of(const Eigen::VectorXd& c) {
  const double largest = c.cwiseAbs().maxCoeff();
  if (!c.allFinite() || largest < least_size) return std::nullopt;
  return std::exp2(std::ilogb(largest));
}

}  // namespace polhode
