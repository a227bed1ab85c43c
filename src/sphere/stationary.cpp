// The stationary density of sphere/kolmogorov.hpp, and whether there is but one.
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "algebra/decompositions.hpp"
#include "algebra/sparse_blocks.hpp"
#include "sphere/galerkin/raise_degree.hpp"
#include "sphere/kolmogorov.hpp"

namespace polhode {
namespace {

constexpr std::array degrees{8, 12, 16, 24, 32, 48, 64, 96};
constexpr int most_sparse = 5000;   // unknowns in a block: seconds
constexpr double rounding = 1e-14;  // of directions

/// The one axis about which the noise turns; empty if there are more, then it reaches every direction.
std::optional<Eigen::Vector3d> only_axis(const Eigen::Matrix3d& covariance) {
  const auto [values, vectors] = symmetric_eigenpairs_of(covariance);
  if (values[1] > rounding * values[2]) return std::nullopt;
  return Eigen::Vector3d(vectors.col(2));
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
  if (problem.damping != 0 || axis->cross(problem.field).norm() > rounding * problem.field.norm()) return false;
  Eigen::Matrix3d about;  // x -> n cross x
  about << 0, -(*axis)[2], (*axis)[1], (*axis)[2], 0, -(*axis)[0], -(*axis)[1], (*axis)[0], 0;
  return (about * problem.quadratic - problem.quadratic * about).norm() <= rounding * spread;
}

bool has_uniform_law(const sphere_problem& problem) { return problem.damping == 0 && problem.varying.empty(); }

std::string no_unique_law(const sphere_problem& problem) {
  if (conserves_a_component(problem)) return "not unique: a function besides the Casimir is conserved";
  const auto axis = only_axis(problem.covariance);
  if (!axis) return "";
  const auto rests = [&](const Eigen::Vector3d& v) { return axis->cross(v).norm() <= rounding * v.norm(); };
  if (!problem.varying.empty() || !rests(problem.quadratic * *axis) || !rests(problem.field)) return "";
  return problem.has_field()
             ? "not unique: the one axis of the noise is an equilibrium, on which the state rests for ever; a second "
               "noise vector, or one off the axis, would be needed"
             : "not unique: the one axis of the noise is an axis of the body, on which it rests for ever; a second "
               "noise vector, or one off the axis, would be needed";
}

stationary_law stationary(const sphere_problem& problem, double tolerance, int wanted) {
  if (!problem.has_noise())
    return {.reason = "no noise: every attractor carries a stationary law, and none has a density"};
  if (const auto reason = no_unique_law(problem); !reason.empty()) return {.reason = reason};
  if (has_uniform_law(problem)) {
    const int degree = wanted > 0 ? wanted : degrees[0];
    const Eigen::VectorXd uniform = Eigen::VectorXd::Unit(harmonic_count(degree), 0) / std::sqrt(4 * std::numbers::pi);
    return {.density = uniform, .change = 0 * uniform, .uncertainty = 0, .degree = degree, .reason = {}};
  }
  const double needed = needed_degree(problem);
  stationary_law last;
  three_agree agreement;
  for (const int degree : degrees_to_try(degrees, wanted)) {
    auto density = left_null_vector(backward_operator(problem, degree), most_sparse);
    if (!density) break;
    *density /= std::sqrt(4 * std::numbers::pi);  // integral one
    Eigen::VectorXd change = *density;
    const bool first = !last.density;
    if (!first) change.head(last.density->size()) -= *last.density;
    const double size = density->norm(), floor = 1e-15 * size;
    const double agreed = agreement.uncertainty(first ? unbounded : change.norm(), size);
    const double distance = std::max({agreed, change.norm(), floor});
    last = {.density = std::move(density), .change = change, .uncertainty = distance, .degree = degree, .reason = {}};
    if (degree >= needed_share * needed && distance <= std::max(tolerance, 10 * floor)) return last;
  }
  last.reason = not_converged(tolerance, last.degree, needed);
  return last;
}

}  // namespace polhode
