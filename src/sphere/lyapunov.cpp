// SPDX-License-Identifier: Apache-2.0
#include "sphere/lyapunov.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <tuple>
#include <vector>

#include "algebra/sparse_blocks.hpp"
#include "sphere/galerkin/poisson.hpp"
#include "sphere/galerkin/raise_degree.hpp"
#include "sphere/harmonics/angular_velocity.hpp"
#include "sphere/harmonics/backward_operator.hpp"
#include "sphere/harmonics/wigner.hpp"
#include "sphere/stationary.hpp"

namespace polhode {
namespace {

constexpr std::array frame_degrees{4, 6, 8, 10, 12, 14, 16, 20, 24, 28, 32};
constexpr int affordable = 7000;  // unknowns in the block: seconds
constexpr double stretching_rounding = 1e-14;
constexpr double cancelled = 4e-15;   // of the terms of an entry
constexpr int stretching_degree = 2;  // a lower degree cuts off what is asked for

sparse_matrix bracket(const sparse_matrix& a, const sparse_matrix& b) {
  return sparse_matrix(a * b) - sparse_matrix(b * a);
}

struct frame_operator {
  sparse_matrix generator;     // from one degree to those that are kept
  Eigen::VectorXd stretching;  // coefficients of s
};

/// What the operators of one equation's frames are sums of, whatever its dissipation t and noise: entries of one
/// pattern.
struct frame_parts {
  sparse_matrix pattern;
  Eigen::VectorXd free, damped;          // t times the second
  std::array<Eigen::VectorXd, 6> noise;  // of covariance entries 11, 22, 33, 12, 23, 31; the last three: or none
  Eigen::VectorXd stretching, damped_stretching;
};

void drop_cancelled(sparse_matrix& a) {
  if (a.nonZeros() > 0) a.prune(a.coeffs().cwiseAbs().maxCoeff(), 1e-15);
}

/// Zero, with an entry wherever one of them has one.
sparse_matrix pattern_of(const std::vector<sparse_matrix>& all) {
  sparse_matrix out(all.front().rows(), all.front().cols());
  for (const auto& part : all) out += part;
  out.coeffs().setZero();
  return out;
}

/// Drops what cancelled and all columns that no sum of these mixes with those that the vector has.
void keep_block(std::vector<sparse_matrix>& all, const Eigen::VectorXd& vector) {
  for (auto& part : all) drop_cancelled(part);
  const sparse_matrix square = pattern_of(all).topRows(vector.size());
  std::vector<bool> inside(static_cast<std::size_t>(vector.size()));
  for (const int i : blocks_of(square, vector)) inside[static_cast<std::size_t>(i)] = true;
  for (auto& part : all) part.prune([&](int, int column, double) { return inside[static_cast<std::size_t>(column)]; });
}

/// beyond: 2 for all that the generator makes of functions of the degree, 0 for its projection.
frame_parts parts_on_frames(const angular_velocity& of, int degree, int beyond, bool mixed_noise) {
  const int inside = degree + beyond + 1;  // so that products of two coordinates are exact
  const auto turn = wigner_generators(inside);
  const auto x = wigner_coordinates(inside, turn);
  const int size = wigner_count(degree), rows = wigner_count(degree + beyond);
  sparse_matrix free(wigner_count(inside), wigner_count(inside)), damped = free;
  std::vector<sparse_matrix> all(2);
  const auto tall = [&](const sparse_matrix& m) -> sparse_matrix { return m.block(0, 0, rows, size); };
  const polynomial squares{.quadratic = of.a}, along{.linear = of.b.transpose()};
  const sparse_matrix xx = multiplying_by(squares, x), bx = multiplying_by(along, x);
  for (std::size_t i = 0; i < 3; ++i) {
    free -= sparse_matrix(multiplying_by(rate_polynomial(of, int(i)), x) * turn.left[i]);
    damped -= sparse_matrix(multiplying_by(cross_polynomial(of, int(i)), x) * turn.left[i]);
    all.push_back(tall(0.5 * sparse_matrix(turn.left[i] * turn.left[i])));
  }
  for (std::size_t i = 0; i < 3 && mixed_noise; ++i) {
    const auto &one = turn.left[i], &other = turn.left[(i + 1) % 3];
    all.push_back(tall(0.5 * (sparse_matrix(one * other) + sparse_matrix(other * one))));
  }
  // right_2 right_1 (x.Ax) = -2 w.Av and right_2 right_2 (x.Ax) = 2 (v.Av - x.Ax)
  const sparse_matrix wv = -0.5 * bracket(turn.right[1], bracket(turn.right[0], xx));
  const sparse_matrix vv = xx + 0.5 * bracket(turn.right[1], bracket(turn.right[1], xx));
  all[0] = tall(free + sparse_matrix(vv * turn.right[2]));
  all[1] = tall(damped - sparse_matrix(wv * turn.right[2]));
  frame_parts out;
  out.stretching = -Eigen::VectorXd(wv.col(0)).head(size);
  out.damped_stretching = Eigen::VectorXd(sparse_matrix(xx + bx - vv).col(0)).head(size);
  keep_block(all, out.stretching.cwiseAbs() + out.damped_stretching.cwiseAbs());
  out.pattern = pattern_of(all);
  const auto entries = [&](const sparse_matrix& part) -> Eigen::VectorXd {
    return sparse_matrix(out.pattern + part).coeffs();
  };
  out.free = entries(all[0]);
  out.damped = entries(all[1]);
  for (std::size_t i = 2; i < all.size(); ++i) out.noise[i - 2] = entries(all[i]);
  return out;
}

/// Those of the last body that was asked for are kept unless they are large: maps and searches ask for hundreds.
std::shared_ptr<const frame_parts> known_parts(const angular_velocity& of, int degree, int beyond, bool mixed_noise) {
  constexpr Eigen::Index most_entries = 500'000;  // 30 MB
  static std::mutex one_at_a_time;
  static angular_velocity last{Eigen::Matrix3d::Zero(), Eigen::Vector3d::Zero()};
  static std::map<std::tuple<int, int, bool>, std::shared_ptr<const frame_parts>> kept;
  const std::lock_guard lock(one_at_a_time);
  if (last != of) kept.clear();
  last = of;
  if (const auto found = kept.find({degree, beyond, mixed_noise}); found != kept.end()) return found->second;
  const auto made = std::make_shared<const frame_parts>(parts_on_frames(of, degree, beyond, mixed_noise));
  if (made->pattern.nonZeros() <= most_entries) kept[{degree, beyond, mixed_noise}] = made;
  return made;
}

frame_operator operator_on_frames(const sphere_problem& problem, int degree, int beyond) {
  const double t = problem.damping * problem.radius;
  const auto& q = problem.covariance;
  const std::array noise{q(0, 0), q(1, 1), q(2, 2), q(0, 1), q(1, 2), q(2, 0)};
  const bool mixed = std::any_of(noise.begin() + 3, noise.end(), [](double x) { return x != 0; });
  const auto parts = known_parts(angular_velocity_of(problem), degree, beyond, mixed);
  Eigen::VectorXd entries = parts->free + t * parts->damped;
  Eigen::VectorXd terms = parts->free.cwiseAbs() + t * parts->damped.cwiseAbs();
  for (std::size_t i = 0; i < noise.size(); ++i)
    if (noise[i] != 0) {
      entries += noise[i] * parts->noise[i];
      terms += std::fabs(noise[i]) * parts->noise[i].cwiseAbs();
    }
  frame_operator out{parts->pattern, parts->stretching + t * parts->damped_stretching};
  // Each beside its own terms: weak dissipation next to strong noise is not what cancelled.
  out.generator.coeffs() = (entries.array().abs() > cancelled * terms.array()).select(entries, 0);
  out.generator.prune([](int, int, double entry) { return entry != 0; });
  return out;
}

}  // namespace

double kaplan_yorke(double lambda1, double sum) {
  if (sum > -1e-13) return 2;
  return lambda1 > 0 ? 1 + lambda1 / (lambda1 - sum) : 0;
}

lyapunov_exponents lyapunov(const sphere_problem& problem, double tolerance, int wanted) {
  if (!problem.has_noise()) return {.reason = "no noise: no random flow"};
  if (!problem.varying.empty()) return {.reason = "unknown: the noise depends on the state and stretches as well"};
  const double drawn_tolerance = tolerance / (60 * std::max(problem.damping, 1e-300));
  const auto drawn = stationary_mean(
      problem, [&](const Eigen::Vector3d& pi) { return (0.5 * (problem.quadratic * pi) + problem.field / 3).dot(pi); },
      drawn_tolerance);
  if (!drawn.value) return {.reason = drawn.reason};
  const double needed = needed_degree(problem),
               size = operator_on_frames(problem, frame_degrees[0], 0).stretching.norm();
  const bool proved =
      wanted > 0 || needed_share * needed > frame_degrees.back();  // else three degrees tell, and are cheaper
  const auto lambda1_at = [&](int degree) -> std::optional<projected_value> {
    if (degree < stretching_degree) return projected_value{.value = 0, .floor = 0, .resolved = false};
    const auto frames = operator_on_frames(problem, degree, proved ? 2 : 0);
    auto found = poisson_mean(frames.generator, frames.stretching, affordable, frame_supremum);
    if (found && !proved && size > 0) found->bound = unbounded;  // a spherical body does not stretch at all
    if (found) found->floor = std::max(found->floor, stretching_rounding * frames.stretching.norm());
    return found;
  };
  const auto lambda1 = raise_degree(degrees_to_try(frame_degrees, wanted), {.absolute = tolerance, .size = size},
                                    needed, lambda1_at, wanted);
  const double c = problem.radius, trace = problem.quadratic.trace();
  lyapunov_exponents found;
  found.lambda1 = lambda1.value;
  found.uncertainty = lambda1.uncertainty;
  found.sum = -problem.damping * (c * c * trace - 6 * *drawn.value);
  found.sum_uncertainty = 6 * problem.damping * drawn.uncertainty;
  if (lambda1.value) found.dimension = kaplan_yorke(*lambda1.value, found.sum);
  found.degree = lambda1.degree;
  found.reason = lambda1.reason;
  if (found.reason.empty() && found.sum_uncertainty > tolerance)
    found.reason = "the sum is " + not_converged(tolerance, drawn.degree, needed) + " on the sphere";
  return found;
}

}  // namespace polhode
