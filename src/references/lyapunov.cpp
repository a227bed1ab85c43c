#include "references/lyapunov.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "references/poisson.hpp"
#include "references/raise_degree.hpp"
#include "references/sparse_blocks.hpp"
#include "references/wigner.hpp"

namespace polhode {
namespace {

constexpr std::array degrees{4, 6, 8, 10, 12, 14, 16, 20, 24, 28, 32};
constexpr int affordable = 7000;  // unknowns in the block: seconds
constexpr double rounding = 1e-14;
constexpr int stretching_degree = 2;  // a lower degree cuts off what is asked for

sparse_matrix bracket(const sparse_matrix& a, const sparse_matrix& b) {
  return sparse_matrix(a * b) - sparse_matrix(b * a);
}

struct frame_operator {
  sparse_matrix generator;     // from one degree to those that are kept
  Eigen::VectorXd stretching;  // coefficients of s
};

/// What the operators of one body's frames are sums of, whatever its dissipation t and noise.
struct frame_parts {
  sparse_matrix free, damped;          // t times the second
  std::array<sparse_matrix, 6> noise;  // of covariance entries 11, 22, 33, 12, 23, 31
  Eigen::VectorXd stretching, damped_stretching;
};

/// a: radius over inertia. beyond: 2 for all that the generator makes of functions of the degree, 0 for its projection.
frame_parts parts_on_frames(const Eigen::Array3d& a, int degree, int beyond) {
  const int inside = degree + beyond + 1;  // so that products of two coordinates are exact
  const auto turn = wigner_generators(inside);
  const auto x = wigner_coordinates(inside, turn);
  const int size = wigner_count(degree), rows = wigner_count(degree + beyond);
  sparse_matrix free(wigner_count(inside), wigner_count(inside)), damped = free, xx = free;
  const auto tall = [&](const sparse_matrix& all) { return sparse_matrix(all.block(0, 0, rows, size)); };
  frame_parts out;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    free -= a[long(i)] * sparse_matrix(x[i] * turn.left[i]);
    damped -= (a[long(k)] - a[long(j)]) * sparse_matrix(sparse_matrix(x[j] * x[k]) * turn.left[i]);
    xx += a[long(i)] * sparse_matrix(x[i] * x[i]);
    out.noise[i] = tall(0.5 * sparse_matrix(turn.left[i] * turn.left[i]));
    out.noise[3 + i] =
        tall(0.5 * (sparse_matrix(turn.left[i] * turn.left[j]) + sparse_matrix(turn.left[j] * turn.left[i])));
  }
  // right_2 right_1 (x.Ax) = -2 w.Av and right_2 right_2 (x.Ax) = 2 (v.Av - x.Ax)
  const sparse_matrix wv = -0.5 * bracket(turn.right[1], bracket(turn.right[0], xx));
  const sparse_matrix vv = xx + 0.5 * bracket(turn.right[1], bracket(turn.right[1], xx));
  out.free = tall(free + sparse_matrix(vv * turn.right[2]));
  out.damped = tall(damped - sparse_matrix(wv * turn.right[2]));
  out.stretching = -Eigen::VectorXd(wv.col(0)).head(size);
  out.damped_stretching = Eigen::VectorXd(sparse_matrix(xx - vv).col(0)).head(size);
  return out;
}

/// Those of the last body that was asked for are kept up to some degree: maps and searches ask for hundreds.
std::shared_ptr<const frame_parts> known_parts(const Eigen::Array3d& a, int degree, int beyond) {
  constexpr int most_kept = 16;  // 10 MB
  if (degree > most_kept) return std::make_shared<frame_parts>(parts_on_frames(a, degree, beyond));
  static std::mutex one_at_a_time;
  static Eigen::Array3d last = Eigen::Array3d::Zero();
  static std::map<std::pair<int, int>, std::shared_ptr<const frame_parts>> kept;
  const std::lock_guard lock(one_at_a_time);
  if ((last != a).any()) kept.clear();
  last = a;
  auto& found = kept[{degree, beyond}];
  if (!found) found = std::make_shared<frame_parts>(parts_on_frames(a, degree, beyond));
  return found;
}

frame_operator operator_on_frames(const sphere_problem& problem, int degree, int beyond) {
  const double c = problem.radius, t = problem.theta * c;
  const auto parts = known_parts(c / Eigen::Array3d(problem.inertia.data()), degree, beyond);
  const auto& q = problem.covariance;
  sparse_matrix generator = parts->free;
  if (t != 0) generator += t * parts->damped;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (const double own = q(long(i), long(i)); own != 0) generator += own * parts->noise[i];
    if (const double mixed = q(long(i), long(j)); mixed != 0) generator += mixed * parts->noise[3 + i];
  }
  generator.prune(generator.coeffs().cwiseAbs().maxCoeff(), 1e-15);  // what cancelled
  return {generator, parts->stretching + t * parts->damped_stretching};
}

/// A bound of |f| over all frames: functions of one l and right index b are at most sqrt(2 l + 1) |f_lb|, as the rows
/// of a rotation are unit vectors.
double frame_supremum(const Eigen::VectorXd& f) {
  double sum = 0;
  for (int l = 0; wigner_count(l) <= f.size(); ++l)
    for (int b = -l; b <= l; ++b) {
      double square = 0;
      for (int a = -l; a <= l; ++a) square += std::pow(f[wigner_index(l, a, b)], 2);
      sum += std::sqrt((2 * l + 1) * square);
    }
  return sum;
}

}  // namespace

double kaplan_yorke(double lambda1, double sum) {
  if (sum > -1e-13) return 2;
  return lambda1 > 0 ? 1 + lambda1 / (lambda1 - sum) : 0;
}

lyapunov_exponents lyapunov(const sphere_problem& problem, double tolerance, int wanted) {
  if (problem.covariance.isZero(0)) return {.reason = "no noise: no random flow"};
  const double energy_tolerance = tolerance / (60 * std::max(problem.theta, 1e-300));
  const auto energy = stationary_mean(problem, *named_observable("energy", problem.inertia), energy_tolerance);
  if (!energy.value) return {.reason = energy.reason};
  const double needed = needed_degree(problem), size = operator_on_frames(problem, degrees[0], 0).stretching.norm();
  const bool proved = wanted > 0 || needed_share * needed > degrees.back();  // else three degrees tell, and are cheaper
  const auto lambda1_at = [&](int degree) -> std::optional<projected_value> {
    if (degree < stretching_degree) return projected_value{.value = 0, .floor = 0, .resolved = false};
    const auto frames = operator_on_frames(problem, degree, proved ? 2 : 0);
    auto found = poisson_mean(frames.generator, frames.stretching, affordable, frame_supremum);
    if (found && !proved) found->bound = unbounded;
    if (found) found->floor = std::max(found->floor, rounding * frames.stretching.norm());
    return found;
  };
  const auto lambda1 =
      raise_degree(degrees_to_try(degrees, wanted), {.absolute = tolerance, .size = size}, needed, lambda1_at, wanted);
  const double c = problem.radius, trace = Eigen::Array3d(problem.inertia.data()).inverse().sum();
  lyapunov_exponents found;
  found.lambda1 = lambda1.value;
  found.uncertainty = lambda1.uncertainty;
  found.sum = -problem.theta * (c * c * trace - 6 * *energy.value);
  found.sum_uncertainty = 6 * problem.theta * energy.uncertainty;
  if (lambda1.value) found.dimension = kaplan_yorke(*lambda1.value, found.sum);
  found.degree = lambda1.degree;
  found.reason = lambda1.reason;
  if (found.reason.empty() && found.sum_uncertainty > tolerance)
    found.reason = "the sum is " + not_converged(tolerance, energy.degree, needed) + " on the sphere";
  return found;
}

}  // namespace polhode
