#include "sphere/harmonics/backward_operator.hpp"

#include <algorithm>
#include <cmath>

#include "algebra/decompositions.hpp"
#include "sphere/harmonics/angular_velocity.hpp"

namespace polhode {

sparse_matrix backward_operator(const sphere_problem& problem, int degree) {
  const int inside = degree + 1;  // so that products of two coordinates are exact up to the degree
  const auto x = coordinates(inside);
  const auto turn = rotation_generators(inside);
  sparse_matrix generator(harmonic_count(inside), harmonic_count(inside));
  const double c = problem.radius;
  const auto velocity = angular_velocity_of(problem);
  for (std::size_t i = 0; i < 3; ++i) {
    const sparse_matrix omega = multiplying_by(rate_polynomial(velocity, int(i)), x),
                        across = multiplying_by(cross_polynomial(velocity, int(i)), x);
    generator -= sparse_matrix(sparse_matrix(omega + problem.damping * c * across) * turn[i]);
    for (std::size_t l = 0; l < 3; ++l) {
      const double q = problem.covariance(long(i), long(l));
      if (q != 0) generator += 0.5 * q * sparse_matrix(turn[i] * turn[l]);
    }
  }
  for (const auto& sigma : problem.varying) {
    sparse_matrix along(generator.rows(), generator.cols());
    for (std::size_t i = 0; i < 3; ++i) {
      const polynomial p{.constant = sigma.constant[long(i)], .linear = c * sigma.slope.row(long(i))};
      along += multiplying_by(p, x) * turn[i];
    }
    generator += 0.5 * sparse_matrix(along * along);
  }
  sparse_matrix corner = generator.block(0, 0, harmonic_count(degree), harmonic_count(degree));
  corner.prune(corner.coeffs().cwiseAbs().maxCoeff(), 1e-15);  // what cancelled
  return corner;
}

sparse_matrix tall_backward_operator(const sphere_problem& problem, int degree) {
  return backward_operator(problem, degree + 2).leftCols(harmonic_count(degree));
}

double needed_degree(const sphere_problem& problem) {
  const double c = problem.radius, turning = c * problem.spread();
  const double damping = problem.damping * c * (turning + problem.field.norm());
  const double shear = std::hypot(turning, damping), trace = noise_rate(problem);
  const Eigen::Vector3d noise = symmetric_eigenpairs_of(problem.covariance).values;
  const double across = std::max(noise[0], 0.0) + std::max(noise[1], 0.0) + shear * shear / trace;
  return 10 * std::sqrt(3 * std::max(shear / trace, std::min(shear, damping) / std::max(across, 1e-300)));
}

double noise_rate(const sphere_problem& p) {
  double rate = p.covariance.trace();
  for (const auto& sigma : p.varying) rate += std::pow(sigma.constant.norm() + p.radius * sigma.slope.norm(), 2);
  return rate;
}

}  // namespace polhode
