// SPDX-License-Identifier: Apache-2.0
#include "support/second_opinions.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <optional>

#include "algebra/decompositions.hpp"
#include "algebra/sparse_blocks.hpp"
#include "sphere/harmonics/backward_operator.hpp"
#include "sphere/harmonics/harmonics.hpp"
#include "sphere/lyapunov.hpp"
#include "support/body_of_revolution.hpp"
#include "support/dense.hpp"
#include "support/gibbs_about_the_other_axis.hpp"
#include "support/power_series_in_time.hpp"
#include "support/sphere_collocation.hpp"

namespace polhode::test {
namespace {

constexpr int most_second = 450;            // unknowns of a dense block
constexpr int highest_second = 52;          // degree
constexpr int collocated = 24;              // the degree up to which a collocation may resolve as much
constexpr double is_an_opinion = 1e-2;      // of its size, at worst
constexpr double lost_to_rounding = 1e-13;  // of a generator's norm

/// At two resolutions: the finer, uncertain by what they differ by and what rounding may do; nothing if that is all.
template <class ValueAt>
void add_refined(opinions& all, const ValueAt& value_at, int coarse, int fine, double size, double rounding) {
  const double rough = value_at(coarse), value = value_at(fine);
  const double uncertainty = std::fabs(value - rough) + rounding;
  if (uncertainty <= is_an_opinion * size) all.push_back({value, uncertainty});
}

/// Of the generator on n points around: about the norm of its second derivatives beside a pole, and of its drift.
double stiffness(const sphere_problem& p, int n) {
  const double shear = p.radius * std::hypot(1, p.damping * p.radius) * p.spread();
  return p.covariance.trace() * std::pow(n, 4) / 4 + shear * n * n;
}

std::optional<second_opinion> projected_expectation(const attacked_scene& s, const sphere_function& f, int degree) {
  if (degree > highest_second) return std::nullopt;
  const sparse_matrix whole = backward_operator(s.problem, degree);
  Eigen::VectorXd c = harmonic_coefficients([&](const Eigen::Vector3d& x) { return f(s.problem.radius * x); }, degree);
  c = c.unaryExpr([&, least = 1e-14 * c.norm()](double x) { return std::fabs(x) < least ? 0.0 : x; });
  const auto block = blocks_of(whole, c);
  const Eigen::MatrixXd part = s.time * Eigen::MatrixXd(submatrix(whole, block));
  if (part.rows() > most_second || part.norm() > 1e6) return std::nullopt;
  const Eigen::VectorXd start = c(block), y = harmonics_at(s.start.normalized(), degree)(block);
  return second_opinion{y.dot(exponential_of(part) * start), 1e-12 * c.norm() + 1e-16 * part.norm() * c.norm(), false};
}

std::optional<double> projected_mean(const sphere_problem& p, const sphere_function& f, int degree) {
  const auto density = left_null_vector(backward_operator(p, degree), 2500);
  if (!density) return std::nullopt;
  const Eigen::VectorXd c = harmonic_coefficients([&](const Eigen::Vector3d& x) { return f(p.radius * x); }, degree);
  return c.dot(*density) / std::sqrt(4 * std::numbers::pi);
}

}  // namespace

double supremum_of(const sphere_problem& p, const sphere_function& f) {
  double largest = 0;
  for (int i = 0; i < 6; ++i)
    largest = std::max(largest, std::fabs(f((i % 2 == 0 ? 1 : -1) * p.radius * Eigen::Vector3d::Unit(i / 2))));
  return largest;
}

opinions opinions_of_expectation(const attacked_scene& s, const std::string& observable, int degree, bool dear) {
  const auto& p = s.problem;
  const auto f = *named_observable(observable, p);
  const bool energy = observable == "energy";
  opinions all;
  const double size = energy ? f(s.start) : supremum_of(p, f);
  const Eigen::Vector3d x = s.start / p.radius;
  const auto rounding = [&](int n) { return lost_to_rounding * size * std::max(1.0, 0.01 * s.time * stiffness(p, n)); };
  const auto body = energy ? revolution(p) : std::nullopt;
  if (body) {
    const auto on_a_line = [&](int n) { return energy_on_a_line(*body, x[body->axis], s.time, n); };
    if (rounding(56) < 1e-4 * size) add_refined(all, on_a_line, 40, 56, size, rounding(56));
  } else if (const auto by_series = energy ? energy_by_series(p, s.start, s.time, 1e-12 * size) : std::nullopt) {
    all.push_back({by_series->value, by_series->remainder + 1e-15 * size});
  } else if (dear && degree <= collocated && rounding(13) < 1e-4 * size) {
    const auto on_a_grid = [&](int n) {
      return sphere_collocation(n, drift_of(p), p.covariance)
          .expectation([&](const Eigen::Vector3d& y) { return f(p.radius * y); }, x, s.time);
    };
    add_refined(all, on_a_grid, 9, 13, size, rounding(13));
  }
  if (const auto higher = projected_expectation(s, f, 2 * degree + 4)) all.push_back(*higher);
  return all;
}

opinions opinions_of_gap(const attacked_scene& s, double found, int degree, bool dear) {
  const auto& p = s.problem;
  opinions all;
  const auto rounding = [&](int n) { return lost_to_rounding * stiffness(p, n); };
  if (const auto body = revolution(p)) {
    add_refined(
        all, [&](int n) { return gap_on_a_line(*body, n, 4); }, 40, 56, found, rounding(56));
  } else if (dear && degree <= collocated) {
    const auto on_a_grid = [&](int n) { return sphere_collocation(n, drift_of(p), p.covariance).gap(); };
    add_refined(all, on_a_grid, 11, 15, found, rounding(15));
  }
  const int higher = degree > 20 ? degree * 5 / 4 : 2 * degree + 4;
  if (higher > highest_second) return all;
  const sparse_matrix whole = backward_operator(p, higher);
  const sparse_matrix rest = whole.block(1, 1, whole.rows() - 1, whole.cols() - 1);
  double slowest = -HUGE_VAL;
  for (const auto& block : connected_blocks(rest)) {
    const Eigen::MatrixXd part(submatrix(rest, block));
    if (part.rows() > most_second) return all;
    slowest = std::max(slowest, eigenvalues_of(part).real().maxCoeff());
  }
  all.push_back({-slowest, 1e-15 * whole.norm(), false});
  return all;
}

void add_collocated_mean(opinions& all, const sphere_problem& p, const sphere_function& f, double size) {
  const auto turned_by = [&](const Eigen::Matrix3d& turn, int n) {
    const auto drift = [&, b = drift_of(p)](const Eigen::Vector3d& x) -> Eigen::Vector3d {
      return turn * b(turn.transpose() * x);
    };
    const sphere_collocation grid(n, drift, turn * p.covariance * turn.transpose());
    return grid.mean_and_rounding([&](const Eigen::Vector3d& x) { return f(p.radius * (turn.transpose() * x)); });
  };
  const Eigen::Matrix3d askew = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const auto rough = turned_by(askew, 9), fine = turned_by(Eigen::Matrix3d::Identity(), 13);
  const double uncertainty = std::fabs(fine.value - rough.value) + fine.rounding + lost_to_rounding * size;
  if (uncertainty <= is_an_opinion * size) all.push_back({fine.value, uncertainty});
}

opinions opinions_of_mean(const attacked_scene& s, const sphere_function& f, int degree, bool dear) {
  const auto& p = s.problem;
  const auto i = inertia_of(p);
  opinions all;
  const double size = std::fabs(f(s.start)), trace = p.quadratic.trace();
  const auto body = revolution(p);
  if (i[0] == i[1] && i[1] == i[2]) {
    all.push_back({size, 1e-14 * size});
  } else if (p.damping == 0) {
    const double value = p.radius * p.radius * trace / 6;
    all.push_back({value, 1e-14 * value});
  } else if (s.isotropic || body) {
    const double beta = 2 * p.damping / (s.isotropic ? p.covariance(0, 0) : body->across);
    const double least = p.radius * p.radius / (2 * *std::ranges::max_element(i));
    const double value = least + gibbs_about_the_other_axis(i, p.radius, beta)[3];
    all.push_back({value, 1e-14 * value});
  } else if (dear && degree <= collocated) {
    add_collocated_mean(all, p, f, size);
  }
  if (2 * degree + 4 > highest_second) return all;
  const auto higher = projected_mean(p, f, 2 * degree + 4), high = projected_mean(p, f, 3 * degree / 2 + 3);
  if (!higher || !high) return all;
  all.push_back({*higher, std::fabs(*higher - *high) + 4e-12 * size, false});
  return all;
}

opinions opinions_of_lambda1(const attacked_scene& s, int degree) {
  const auto& p = s.problem;
  opinions all;
  if (const auto body = revolution(p))
    add_refined(
        all, [&](int n) { return lambda1_on_the_sphere(*body, n); }, 13, 17, p.radius * p.spread(),
        lost_to_rounding * p.radius);
  if (degree > 10) return all;
  const auto higher = lyapunov(p, 1e-12 * p.radius, degree + 6);
  if (higher.lambda1) all.push_back({*higher.lambda1, 1e-13 * p.radius, false});
  return all;
}

}  // namespace polhode::test
