// SPDX-License-Identifier: Apache-2.0
#include "sphere/uniqueness.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <optional>

#include "algebra/decompositions.hpp"
#include "sphere/equilibria.hpp"

namespace polhode {
namespace {

constexpr double direction_rounding = 1e-14;

/// The one axis about which the noise turns; empty if there are more, then it reaches every direction.
std::optional<Eigen::Vector3d> only_axis(const Eigen::Matrix3d& covariance) {
  const auto [values, vectors] = symmetric_eigenpairs_of(covariance);
  if (values[1] > direction_rounding * values[2]) return std::nullopt;
  return Eigen::Vector3d(vectors.col(2));
}

/// Where the noise depends on the state: at an equilibrium of h, where it moves nothing.
bool rests_somewhere(const sphere_problem& p) {
  if (p.varying.empty() || !p.covariance.isZero(0)) return false;
  return std::ranges::any_of(equilibria(p), [&](const equilibrium& e) {
    const Eigen::Vector3d at = p.radius * e.direction;
    return std::ranges::all_of(p.varying, [&](const affine_noise& v) {
      const double size = v.constant.norm() + p.radius * v.slope.norm();
      return at.cross(v.constant + v.slope * at).norm() <= direction_rounding * p.radius * size;
    });
  });
}

}  // namespace

// A conserved f has n.L f = 0, so f = f(n.x), and n.(x cross Omega) = 0 for all x: the field lies along n and
// `quadratic` commutes with turns about n.
bool conserves_a_component(const sphere_problem& problem) {
  if (!problem.varying.empty()) return false;
  const auto axis = only_axis(problem.covariance);
  if (!axis) return false;
  const double spread = problem.spread();
  if (spread == 0 && !problem.has_field()) return true;
  if (problem.damping != 0 || axis->cross(problem.field).norm() > direction_rounding * problem.field.norm())
    return false;
  Eigen::Matrix3d about;  // x -> n cross x
  about << 0, -(*axis)[2], (*axis)[1], (*axis)[2], 0, -(*axis)[0], -(*axis)[1], (*axis)[0], 0;
  return (about * problem.quadratic - problem.quadratic * about).norm() <= direction_rounding * spread;
}

bool has_uniform_law(const sphere_problem& problem) { return problem.damping == 0 && problem.varying.empty(); }

std::string no_unique_law(const sphere_problem& problem) {
  if (rests_somewhere(problem))
    return "not unique: all noise vanishes at an equilibrium of h, on which the state rests for ever";
  if (conserves_a_component(problem)) return "not unique: a function besides the Casimir is conserved";
  const auto axis = only_axis(problem.covariance);
  if (!axis) return "";
  const auto rests = [&](const Eigen::Vector3d& v) { return axis->cross(v).norm() <= direction_rounding * v.norm(); };
  if (!problem.varying.empty() || !rests(problem.quadratic * *axis) || !rests(problem.field)) return "";
  return problem.has_field()
             ? "not unique: the one axis of the noise is an equilibrium, on which the state rests for ever; a second "
               "noise vector, or one off the axis, would be needed"
             : "not unique: the one axis of the noise is an axis of the body, on which it rests for ever; a second "
               "noise vector, or one off the axis, would be needed";
}

}  // namespace polhode
