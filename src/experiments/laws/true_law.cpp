// SPDX-License-Identifier: Apache-2.0
#include "experiments/laws/true_law.hpp"
#include "sphere/harmonics/harmonics.hpp"

#include <cmath>

namespace polhode {
namespace {

constexpr double density_accuracy = 1e-10;  // in L2
constexpr double usable = 1e-4;             // of the density's norm: where that accuracy is out of reach

}  // namespace

stationary_law law_of(const sphere_problem& problem, bool isotropic, double accuracy) {
  auto law = stationary(problem, accuracy);
  if (!isotropic || !law.density) return law;
  const double beta = 2 * problem.damping / problem.covariance(0, 0);
  const auto energy = *named_observable("energy", problem);
  law.density = harmonic_coefficients(
      [&](const Eigen::Vector3d& x) { return std::exp(-beta * energy(problem.radius * x)); }, law.degree);
  *law.density /= unit_of_mean * (*law.density)[0];
  return law;
}

bool is_usable(const stationary_law& law) {
  return law.density && (law.reason.empty() || law.uncertainty <= usable * law.density->norm());
}

stationary_law true_law(const subject& s) {
  return law_of(*s.sphere(), s.model->noise() == noise_class::isotropic, density_accuracy);
}

}  // namespace polhode
