// SPDX-License-Identifier: Apache-2.0
#include "sphere/averaged_gap.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/legendre.hpp>
#include <cmath>
#include <vector>

#include "algebra/decompositions.hpp"
#include "sphere/closed_forms/elliptic_moments.hpp"

namespace polhode {
namespace {

constexpr int functions = 20;          // of an edge
constexpr double largest_power = 300;  // of e, in p

/// Circles about one axis: differences of inverse inertia to the middle and the other axis, noise of the three.
struct edge {
  double c, middle, other, across;  ///< |k_middle - k|, |k_other - k|, |k_other - k_middle|
  double q, q_middle, q_other;
  double beta;  ///< with its sign: ln p grows by it per unit of y
  double length() const { return c * c * middle / 2; }
};

struct coefficients {
  double a, period;
};

/// At y = (1 - left) length.
coefficients averages(const edge& e, double left) {
  const double b2 = e.c * e.c * (1 - left), a2 = b2 * e.middle / e.other, p2 = e.c * e.c - a2;
  const double rest = e.c * e.c * left / p2, m = 1 - rest;
  const auto [one, sin2, sin4] = elliptic_moments_of(m, rest);
  const double time = 4 / std::sqrt(e.middle * e.other * p2);
  const double about = e.across * e.across * a2 * b2 * (sin2 - sin4);
  const double to_other = e.middle * e.middle * b2 * p2 * (sin2 - m * sin4);
  const double to_middle = e.other * e.other * a2 * p2 * (one - sin2 - m * (sin2 - sin4));
  return {time / 2 * (e.q * about + e.q_other * to_other + e.q_middle * to_middle), time * one};
}

struct forms {
  Eigen::MatrixXd stiffness, mass;  ///< the last function is one; the others vanish at the vertex
};

/// Polynomials of s, y = length (1 - (1 - s)^2), which takes the edge off the vertex.
forms forms_on(const edge& e) {
  forms out{Eigen::MatrixXd::Zero(functions + 1, functions + 1), Eigen::MatrixXd::Zero(functions + 1, functions + 1)};
  const auto& nodes = boost::math::quadrature::gauss<double, 100>::abscissa();
  const auto& weights = boost::math::quadrature::gauss<double, 100>::weights();
  for (std::size_t n = 0; n < 2 * nodes.size(); ++n) {
    const double x = (n % 2 == 0 ? 1 : -1) * nodes[n / 2], s = (1 + x) / 2, t = 1 - s;
    const double slope = 2 * t * e.length(), weight = weights[n / 2] / 2;
    const auto [a, period] = averages(e, t * t);
    const double p = std::exp(-e.beta * e.length() * t * t);
    Eigen::VectorXd u(functions + 1), du(functions + 1);
    for (int k = 0; k < functions; ++k) {
      u[k] = t * boost::math::legendre_p(k, x);
      du[k] = -boost::math::legendre_p(k, x) + 2 * t * (k == 0 ? 0 : boost::math::legendre_p_prime(k, x));
    }
    u[functions] = 1;
    du[functions] = 0;
    out.stiffness += weight * p * a / slope * du * du.transpose();
    out.mass += weight * p * period * slope * u * u.transpose();
  }
  return out;
}

/// Of one or two edges.
std::vector<edge> edges_of(const sphere_problem& problem) {
  std::array<int, 3> order{0, 1, 2};
  std::ranges::sort(order, [&](int a, int b) { return problem.quadratic(a, a) > problem.quadratic(b, b); });
  const auto k = [&](int a) { return problem.quadratic(order[a], order[a]); };
  const auto q = [&](int a) { return problem.covariance(order[a], order[a]); };
  const double beta = 2 * problem.damping / q(0), c = problem.radius, whole = k(0) - k(2);
  std::vector<edge> out;
  if (k(1) > k(2)) out.push_back({c, k(1) - k(2), whole, k(0) - k(1), q(2), q(1), q(0), -beta});
  if (k(0) > k(1)) out.push_back({c, k(0) - k(1), whole, k(1) - k(2), q(0), q(1), q(2), beta});
  return out;
}

}  // namespace

std::optional<averaged_rates> averaged_gap(const sphere_problem& problem) {
  const auto& q = problem.covariance;
  const bool isotropic = q.isDiagonal(1e-14) && (q.diagonal().array() == q(0, 0)).all();
  if (!problem.quadratic.isDiagonal(0) || problem.has_field() || !problem.varying.empty()) return std::nullopt;
  if (!(q.diagonal().minCoeff() > 0) || (problem.damping > 0 && !isotropic)) return std::nullopt;
  const auto edges = edges_of(problem);
  if (edges.empty()) return std::nullopt;
  averaged_rates out{HUGE_VAL, HUGE_VAL};
  const auto size = static_cast<Eigen::Index>(edges.size()) * functions + 1;
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(size, size), mass = stiffness;
  for (Eigen::Index n = 0; n < std::ssize(edges); ++n) {
    const edge& e = edges[static_cast<std::size_t>(n)];
    if (std::fabs(e.beta) * e.length() > largest_power) return std::nullopt;
    const forms f = forms_on(e);
    out.odd = std::min(out.odd, generalised_eigenvalues_of(f.stiffness.topLeftCorner(functions, functions),
                                                           f.mass.topLeftCorner(functions, functions))[0]);
    Eigen::VectorXi places = Eigen::VectorXi::LinSpaced(functions + 1, int(n) * functions, int(n + 1) * functions);
    places[functions] = int(size) - 1;
    stiffness(places, places) += f.stiffness;
    mass(places, places) += f.mass;
  }
  out.even = generalised_eigenvalues_of(stiffness, mass)[1];
  return out;
}

}  // namespace polhode
