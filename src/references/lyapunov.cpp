#include "references/lyapunov.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "references/sparse_blocks.hpp"
#include "references/wigner.hpp"

namespace polhode {
namespace {

constexpr std::array degrees{4, 6, 8, 10, 12, 14, 16, 20, 24, 28, 32};
constexpr int affordable = 6000;  // unknowns in the block: tens of seconds
constexpr double rounding = 1e-14;

sparse_matrix bracket(const sparse_matrix& a, const sparse_matrix& b) {
  return sparse_matrix(a * b) - sparse_matrix(b * a);
}

struct frame_operator {
  sparse_matrix generator;
  Eigen::VectorXd stretching;  // coefficients of s
};

frame_operator operator_on_frames(const sphere_problem& problem, int degree) {
  const int inside = degree + 1;  // so that products of two coordinates are exact up to the degree
  const auto turn = wigner_generators(inside);
  const auto x = wigner_coordinates(inside, turn);
  const double c = problem.radius, t = problem.theta * c;
  const Eigen::Array3d a = c / Eigen::Array3d(problem.inertia.data());
  sparse_matrix generator(wigner_count(inside), wigner_count(inside)), xx = generator, one = generator;
  one.setIdentity();
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const sparse_matrix drift = a[long(i)] * x[i] + t * (a[long(k)] - a[long(j)]) * sparse_matrix(x[j] * x[k]);
    generator -= sparse_matrix(drift * turn.left[i]);
    xx += a[long(i)] * sparse_matrix(x[i] * x[i]);
    for (std::size_t l = 0; l < 3; ++l) {
      const double q = problem.covariance(long(i), long(l));
      if (q != 0) generator += 0.5 * q * sparse_matrix(turn.left[i] * turn.left[l]);
    }
  }
  // right_2 right_1 (x.Ax) = -2 w.Av and right_2 right_2 (x.Ax) = 2 (v.Av - x.Ax)
  const sparse_matrix wv = -0.5 * bracket(turn.right[1], bracket(turn.right[0], xx));
  const sparse_matrix vv = xx + 0.5 * bracket(turn.right[1], bracket(turn.right[1], xx));
  const sparse_matrix omega = vv - t * wv, stretching = t * (xx - vv) - wv;
  generator += sparse_matrix(omega * turn.right[2]);
  const int size = wigner_count(degree);
  sparse_matrix corner = generator.block(0, 0, size, size);
  corner.prune(corner.coeffs().cwiseAbs().maxCoeff(), 1e-15);  // what cancelled
  return {corner, Eigen::VectorXd(stretching.col(0)).head(size)};
}

}  // namespace

lyapunov_exponents lyapunov(const sphere_problem& problem, double tolerance) {
  const auto law = stationary(problem, tolerance / 10);
  const auto energy = mean(problem, law, *named_observable("energy", problem.inertia));
  if (!energy.value) return {.reason = energy.reason};
  lyapunov_exponents last;
  for (const int degree : degrees) {
    const auto frames = operator_on_frames(problem, degree);
    const auto nu = left_null_vector(frames.generator, affordable);
    if (!nu) break;
    const double value = nu->dot(frames.stretching);
    const double change = last.lambda1 ? std::fabs(value - *last.lambda1) : std::numeric_limits<double>::infinity();
    last.lambda1 = value;
    last.uncertainty = std::max(change, rounding * frames.stretching.norm());
    last.degree = degree;
    if (last.uncertainty <= tolerance) break;
  }
  if (!last.lambda1 || last.uncertainty > tolerance)
    last.reason =
        fmt::format("not converged to {:g} at degree {}, the last that is affordable", tolerance, last.degree);
  const double c = problem.radius;
  const double trace = Eigen::Array3d(problem.inertia.data()).inverse().sum();
  last.sum = -problem.theta * (c * c * trace - 6 * *energy.value);
  if (last.lambda1.value_or(-1) >= 0)
    last.dimension = 1 + *last.lambda1 / std::max(*last.lambda1, *last.lambda1 - last.sum);
  return last;
}

}  // namespace polhode
