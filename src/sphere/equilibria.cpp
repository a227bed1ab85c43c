// SPDX-License-Identifier: Apache-2.0
#include "sphere/equilibria.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "algebra/decompositions.hpp"

namespace polhode {
namespace {

constexpr double nothing = 1e-14;  // of a component of the field, over all of it
constexpr double flat = 1e-12;     // of a curvature, over the spread of h

/// In principal axes: eigenvalues, the field, and c.
struct secular {
  Eigen::Vector3d lambda, field;
  double c;

  /// sum (b_i / (nu - lambda_i))^2 / c^2 - 1, convex between neighbouring poles.
  double operator()(double nu) const {
    double sum = -1;
    for (int i = 0; i < 3; ++i)
      if (field[i] != 0) sum += std::pow(field[i] / (c * (nu - lambda[i])), 2);
    return sum;
  }
  /// n, but for components of which the field has none.
  Eigen::Vector3d direction(double nu) const {
    Eigen::Vector3d n = Eigen::Vector3d::Zero();
    for (int i = 0; i < 3; ++i)
      if (field[i] != 0) n[i] = field[i] / (c * (nu - lambda[i]));
    return n;
  }
};

/// Between places of different sign, or the one that is nearer to the root by rounding.
double root_between(const secular& f, double above, double below) {
  if (!(f(above) > 0)) return above;
  if (!(f(below) < 0)) return below;
  std::uintmax_t steps = 200;
  const auto [low, high] =
      boost::math::tools::toms748_solve([&](double nu) { return f(nu); }, std::min(above, below),
                                        std::max(above, below), boost::math::tools::eps_tolerance<double>(52), steps);
  return std::midpoint(low, high);
}

struct pole {
  double at, reach;  ///< nearer than so far the function is positive
};

/// Without those that the field does not reach.
std::vector<pole> poles_of(const secular& f) {
  std::vector<pole> out;
  for (int i = 0; i < 3; ++i)
    if (f.field[i] != 0) out.push_back({f.lambda[i], std::fabs(f.field[i]) / f.c});
  std::ranges::sort(out, {}, &pole::at);
  for (std::size_t i = 1; i < out.size();)
    if (out[i].at == out[i - 1].at) {
      out[i - 1].reach = std::hypot(out[i - 1].reach, out[i].reach);
      out.erase(out.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      ++i;
    }
  return out;
}

std::vector<double> multipliers(const secular& f) {
  const auto poles = poles_of(f);
  std::vector<double> out;
  if (poles.empty()) return out;
  const double far = f.field.norm() / f.c;
  out.push_back(root_between(f, poles.front().at - poles.front().reach, poles.front().at - far));
  out.push_back(root_between(f, poles.back().at + poles.back().reach, poles.back().at + far));
  for (std::size_t i = 1; i < poles.size(); ++i) {
    const double a = poles[i - 1].at + poles[i - 1].reach, b = poles[i].at - poles[i].reach;
    if (!(b > a)) continue;
    const double lowest = boost::math::tools::brent_find_minima([&](double nu) { return f(nu); }, a, b, 52).first;
    if (!(f(lowest) < 0)) continue;
    out.push_back(root_between(f, a, lowest));
    out.push_back(root_between(f, b, lowest));
  }
  return out;
}

/// nu = lambda_i where the field has nothing along axis i: what is missing of the length lies there.
std::optional<double> missing_along(const secular& f, int axis) {
  if (f.field[axis] != 0) return std::nullopt;
  for (int j = 0; j < 3; ++j)
    if (j != axis && f.field[j] != 0 && f.lambda[j] == f.lambda[axis]) return std::nullopt;
  const double square = -f(f.lambda[axis]);
  return square > 0 ? std::optional(std::sqrt(square)) : std::nullopt;
}

std::vector<Eigen::Vector3d> directions_of(const secular& f) {
  std::vector<Eigen::Vector3d> out;
  for (const double nu : multipliers(f)) out.push_back(f.direction(nu).normalized());
  for (int axis = 0; axis < 3; ++axis)
    if (const auto length = missing_along(f, axis))
      for (const double sign : {1.0, -1.0}) {
        Eigen::Vector3d n = f.direction(f.lambda[axis]);
        n[axis] = sign * *length;
        out.push_back(n.normalized());
      }
  return out;
}

}  // namespace

Eigen::Matrix3d principal_axes(const sphere_problem& p) {
  if (p.quadratic.isDiagonal(0)) return Eigen::Matrix3d::Identity();
  Eigen::Matrix3d axes = symmetric_eigenpairs_of(p.quadratic).vectors;
  if (axes.determinant() < 0) axes.col(0) *= -1;
  return axes;
}

Eigen::Matrix<double, 3, 2> tangent_frame(const Eigen::Vector3d& direction) {
  Eigen::Index axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  const Eigen::Vector3d next = Eigen::Vector3d::Unit((axis + 1) % 3);
  Eigen::Matrix<double, 3, 2> frame;
  frame.col(0) = (next - direction.dot(next) * direction).normalized();
  frame.col(1) = direction.cross(frame.col(0));
  return frame;
}

Eigen::Matrix2d curvature_at(const sphere_problem& p, const Eigen::Vector3d& direction) {
  const auto frame = tangent_frame(direction);
  const double nu = direction.dot(p.quadratic * direction) + direction.dot(p.field) / p.radius;
  return frame.transpose() * p.quadratic * frame - nu * Eigen::Matrix2d::Identity();
}

std::vector<equilibrium> equilibria(const sphere_problem& p) {
  const Eigen::Matrix3d axes = principal_axes(p);
  const Eigen::Vector3d values = (axes.transpose() * p.quadratic * axes).diagonal();
  secular f{values, axes.transpose() * p.field, p.radius};
  for (double& b : f.field)
    if (std::fabs(b) <= nothing * p.field.norm()) b = 0;
  std::vector<equilibrium> out;
  const double scale = p.spread() + p.field.norm() / p.radius;
  for (const auto& n : directions_of(f)) {
    equilibrium e{axes * n, p.energy(p.radius * (axes * n)), {}};
    e.curvature = symmetric_eigenpairs_of(curvature_at(p, e.direction)).values;
    for (double& k : e.curvature)
      if (std::fabs(k) <= flat * scale) k = 0;
    out.push_back(e);
  }
  std::ranges::stable_sort(out, {}, &equilibrium::energy);
  return out;
}

double barrier_between_wells(const sphere_problem& p) {
  std::vector<double> wells;
  double pass = std::numeric_limits<double>::infinity();
  for (const auto& e : equilibria(p)) {
    if (e.is_least() && e.curvature[0] == 0) return 0;
    if (e.is_least())
      wells.push_back(e.energy);
    else
      pass = std::min(pass, e.energy);
  }
  return wells.size() < 2 ? 0 : std::max(0.0, pass - wells[1]);
}

}  // namespace polhode
