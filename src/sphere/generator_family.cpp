// SPDX-License-Identifier: Apache-2.0
#include "sphere/generator_family.hpp"

#include <Eigen/Dense>
#include <cmath>

#include "algebra/decompositions.hpp"
#include "algebra/logarithm_action.hpp"
#include "sphere/harmonics/backward_operator.hpp"
#include "sphere/harmonics/harmonics.hpp"

namespace polhode {
namespace {

constexpr int fitted_columns = harmonic_count(generator_family::fitted_degree) - 1;

Eigen::VectorXd operator_columns(const sphere_problem& p) {
  const auto whole = backward_operator(p, generator_family::reached_degree);
  return Eigen::MatrixXd(whole.middleCols(1, fitted_columns)).reshaped();
}

// On the unit sphere: a radius c turns k into c k and theta k into c^2 theta k.
sphere_problem turning_about(int axis, double damping) {
  sphere_problem p{Eigen::Matrix3d::Zero(), damping, 1, Eigen::Matrix3d::Zero()};
  p.quadratic(axis, axis) = 1;
  return p;
}

Eigen::Vector3d less_its_mean(const Eigen::Vector3d& v) { return v.array() - v.mean(); }

}  // namespace

body_parameters parameters_of(const sphere_problem& p) {
  const Eigen::Vector3d k = p.quadratic.diagonal();
  return {less_its_mean(k), less_its_mean(p.damping * k), p.covariance};
}

generator_family::generator_family(double radius)
    : radius_(radius), members_(harmonic_count(reached_degree) * fitted_columns, 12) {
  for (int j = 0; j < 3; ++j) {
    members_.col(j) = operator_columns(turning_about(j, 0));
    members_.col(3 + j) = operator_columns(turning_about(j, 1)) - members_.col(j);
  }
  Eigen::Index column = 6;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) {
      sphere_problem p{Eigen::Matrix3d::Zero(), 0, 1, Eigen::Matrix3d::Zero()};
      p.covariance(i, j) = p.covariance(j, i) = 1;
      members_.col(column++) = operator_columns(p);
    }
  // Of least norm: what is invisible stays out, so k and theta k come without their means.
  solve_ = pseudo_inverse(members_);
}

nearest_body generator_family::nearest(const Eigen::MatrixXd& generator) const {
  const auto reached = harmonic_count(reached_degree);
  const Eigen::VectorXd given = generator.topRows(reached).reshaped(), p = solve_ * given;
  const double rest =
      std::hypot((given - members_ * p).norm(), generator.bottomRows(generator.rows() - reached).norm());
  nearest_body out{{p.head<3>() / radius_, p.segment<3>(3) / (radius_ * radius_), {}}, rest / generator.norm()};
  out.parameters.noise << p[6], p[7], p[8], p[7], p[9], p[10], p[8], p[10], p[11];
  return out;
}

std::optional<Eigen::MatrixXd> generator_of_step(const Eigen::MatrixXd& step, double dt) {
  auto columns =
      logarithm_action(step, Eigen::MatrixXd::Identity(step.rows(), fitted_columns + 1).rightCols(fitted_columns));
  if (columns) *columns /= dt;
  return columns;
}

}  // namespace polhode
