// SPDX-License-Identifier: Apache-2.0
#include "sphere/harmonics/backward_operator.hpp"

#include <algorithm>
#include <cmath>

#include "algebra/decompositions.hpp"
#include "sphere/harmonics/angular_velocity.hpp"

namespace polhode {

namespace {

constexpr double cancelled = 1e-15;  // of a term's largest entry

/// A term is rid of what cancelled inside it before it joins the others, whatever their size: next to strong noise a
/// weak dissipation is still all that tells the law from a uniform one.
void add(sparse_matrix& generator, double weight, sparse_matrix term) {
  if (weight == 0 || term.nonZeros() == 0) return;
  term.prune(term.coeffs().cwiseAbs().maxCoeff(), cancelled);
  generator += weight * term;
}

/// -sum_i M[p_i] L_i
template <class Polynomial>
sparse_matrix along_field(const Polynomial& p, const std::array<sparse_matrix, 3>& x,
                          const std::array<sparse_matrix, 3>& turn) {
  sparse_matrix out(turn[0].rows(), turn[0].cols());
  for (int i = 0; i < 3; ++i)
    if (const polynomial factor = p(i); !factor.is_zero())
      out -= sparse_matrix(multiplying_by(factor, x) * turn[std::size_t(i)]);
  return out;
}

/// Entry by entry of A and b, so that a small difference of inertias is a term of its own.
void add_drift(sparse_matrix& generator, const sphere_problem& problem, const std::array<sparse_matrix, 3>& x,
               const std::array<sparse_matrix, 3>& turn) {
  const auto velocity = angular_velocity_of(problem);
  const auto add_part = [&](double weight, const angular_velocity& part) {
    if (weight == 0) return;
    add(generator, weight, along_field([&](int i) { return rate_polynomial(part, i); }, x, turn));
    if (problem.damping == 0) return;
    add(generator, weight * problem.damping * problem.radius,
        along_field([&](int i) { return cross_polynomial(part, i); }, x, turn));
  };
  for (int k = 0; k < 3; ++k) {
    add_part(velocity.b[k], {Eigen::Matrix3d::Zero(), Eigen::Vector3d::Unit(k)});
    for (int l = k; l < 3; ++l) {
      angular_velocity part{Eigen::Matrix3d::Zero(), Eigen::Vector3d::Zero()};
      part.a(k, l) = part.a(l, k) = 1;
      add_part(velocity.a(k, l), part);
    }
  }
}

/// q |L|^2 / 2 is known to the last digit, q the middle one of the diagonal: what two axes share cancels by itself.
void add_constant_noise(sparse_matrix& generator, const Eigen::Matrix3d& covariance, int degree,
                        const std::array<sparse_matrix, 3>& turn) {
  const double shared = median_of(covariance.diagonal());
  sparse_matrix laplacian(generator.rows(), generator.cols());
  laplacian.setIdentity();
  for (int l = 0, at = 0; l <= degree; at += 2 * l + 1, ++l)
    laplacian.coeffs().segment(at, 2 * l + 1).setConstant(-l * (l + 1.0));
  add(generator, 0.5 * shared, laplacian);
  for (int i = 0; i < 3; ++i) {
    const auto& one = turn[std::size_t(i)];
    if (covariance(i, i) != shared) add(generator, 0.5 * (covariance(i, i) - shared), one * one);
    for (int l = i + 1; l < 3; ++l) {
      const auto& other = turn[std::size_t(l)];
      if (covariance(i, l) != 0)
        add(generator, 0.5 * covariance(i, l), sparse_matrix(one * other) + sparse_matrix(other * one));
    }
  }
}

}  // namespace

sparse_matrix backward_operator(const sphere_problem& problem, int degree) {
  const int inside = degree + 1;  // so that products of two coordinates are exact up to the degree
  const auto x = coordinates(inside);
  const auto turn = rotation_generators(inside);
  sparse_matrix generator(harmonic_count(inside), harmonic_count(inside));
  add_drift(generator, problem, x, turn);
  add_constant_noise(generator, problem.covariance, inside, turn);
  sparse_matrix varying(generator.rows(), generator.cols());
  for (const auto& sigma : problem.varying) {
    const sparse_matrix along = along_field(
        [&](int i) { return polynomial{.constant = sigma.constant[i], .linear = problem.radius * sigma.slope.row(i)}; },
        x, turn);
    varying += sparse_matrix(along * along);
  }
  add(generator, 0.5, varying);
  return generator.block(0, 0, harmonic_count(degree), harmonic_count(degree));
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
