// Random and extreme scenes against the references: every answer is compared with a second method.
//
//   gibbs         Gauss-Legendre about another axis, long double     for Gauss-Kronrod about the axis of least energy
//   mean          the Gibbs law, or a density at twice the degree    for Poisson's equation
//   expectation   Pade exponential, dense, at twice the degree       for the Taylor action and its remainder
//   gap           all eigenvalues, dense, at twice the degree        for inverse iteration and three degrees
//   lyapunov      the law of frames, six degrees higher              for Poisson's equation and three degrees
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <unsupported/Eigen/MatrixFunctions>

#include "references/gibbs.hpp"
#include "references/lyapunov.hpp"
#include "references/sparse_blocks.hpp"

namespace polhode::test {

struct attacked_scene {
  sphere_problem problem;
  Eigen::Vector3d start;
  double time;
  bool isotropic;
};

inline std::string words(const attacked_scene& s) {
  const auto& [i, theta, c, q] = s.problem;
  return fmt::format(
      "I {:.17g} {:.17g} {:.17g} theta {:.17g} c {:.17g} Q {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} T {:.17g}",
      i[0], i[1], i[2], theta, c, q(0, 0), q(1, 1), q(2, 2), q(0, 1), q(0, 2), q(1, 2), s.time);
}

/// tame: noise, dissipation and shear of about one size, so that most is answered. Else theta and noise from 1e-6 to
/// 1e3, radius from 1e-3 to 1e3, time from 1e-6 to 1e9.
inline attacked_scene drawn_scene(std::mt19937_64& random, bool tame) {
  const auto between = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
  const auto power = [&](double a, double b) { return std::pow(10, between(a, b)); };
  const auto one_of = [&](int n) { return std::uniform_int_distribution(0, n - 1)(random); };
  attacked_scene s{{{power(-0.5, 0.5), power(-0.5, 0.5), power(-0.5, 0.5)}, 0, 1, {}}, {}, 0, false};
  auto& p = s.problem;
  const auto a = static_cast<std::size_t>(one_of(3)), b = (a + 1) % 3, c = (a + 2) % 3;
  const int shape = one_of(6);
  if (shape == 0) p.inertia[a] = p.inertia[b] * (1 + power(-12, -2));  // nearly symmetric
  if (shape == 1) p.inertia[a] = p.inertia[b];                         // prolate or oblate
  if (shape == 2) p.inertia[a] = p.inertia[b] = p.inertia[c] * power(-3, 3);
  if (shape == 3)
    p.inertia[a] = p.inertia[b] * (1 + power(-12, -2)), p.inertia[c] = p.inertia[b] * (1 + power(-12, -2));
  p.radius = tame ? power(-1, 1) : power(-3, 3);
  p.theta = one_of(5) == 0 ? 0 : tame ? power(-2, 0.5) / p.radius : power(-6, 3);
  const double sigma = tame ? std::sqrt(p.radius) * power(-1.2, 0.5) : power(-6, 3);
  const int noise = one_of(5);
  s.isotropic = noise <= 1;
  Eigen::Matrix3d root = sigma * Eigen::Matrix3d::Identity();
  if (noise == 2) root.diagonal() *= between(0.3, 1), root(long(a), long(a)) *= power(-2, 0);
  if (noise == 3) root = sigma * Eigen::Matrix3d::NullaryExpr([&](Eigen::Index) { return between(-1, 1); });
  if (noise == 4)
    root.leftCols(2).setZero(), root.col(2) = sigma * Eigen::Vector3d(between(-1, 1), between(-1, 1), between(-1, 1));
  if (noise == 4 && one_of(2) == 0) root.col(2) = sigma * Eigen::Vector3d::Unit(one_of(3));
  p.covariance = root * root.transpose();
  s.start = p.radius * Eigen::Vector3d(between(-1, 1), between(-1, 1), between(-1, 1)).normalized();
  s.time = tame ? power(-2, 2) / p.radius : power(-6, 9);
  return s;
}

struct second_opinion {
  double value, uncertainty;
};

/// exp(-x) I_0(x) and 1 - I_1 / I_0 in long double, by Boost and by the first terms of their asymptotic series.
inline std::pair<long double, long double> bessel_in_long_double(long double x) {
  if (x < 500) {
    const long double i0 = boost::math::cyl_bessel_i(0, x), i1 = boost::math::cyl_bessel_i(1, x);
    return {std::exp(-x) * i0, (i0 - i1) / i0};
  }
  long double zero = 1, difference = 0, term0 = 1, term1 = 1;
  for (int k = 1; k < 12; ++k) {
    const auto odd = static_cast<long double>((2 * k - 1) * (2 * k - 1));
    zero += term0 *= odd / (8 * k * x);
    difference += term0 - (term1 *= -(4 - odd) / (8 * k * x));
  }
  return {zero / std::sqrt(2 * std::numbers::pi_v<long double> * x), difference / zero};
}

/// E[Pi_k^2] of the axes in order of increasing inertia, and of h above its least, about the axis of greatest energy.
inline std::array<double, 4> gibbs_about_the_other_axis(std::array<double, 3> i, double c, double beta) {
  using real = long double;
  std::ranges::sort(i);
  const real a = real(c) * c * (real(i[2]) - i[0]) / (2 * real(i[0]) * i[2]);
  const real b = real(c) * c * (real(i[2]) - i[1]) / (2 * real(i[1]) * i[2]);
  std::array<real, 5> sum{};
  // x_1 = z, x_2 = sqrt(1 - z^2) sin: weight exp(-beta a z^2 - beta b (1 - z^2) sin^2); panels that widen
  const auto panel = [&](auto z_at, real low, real high) {
    const auto& nodes = boost::math::quadrature::gauss<real, 30>::abscissa();
    const auto& weights = boost::math::quadrature::gauss<real, 30>::weights();
    for (std::size_t n = 0; n < 2 * nodes.size(); ++n) {
      const real u = (n % 2 == 0 ? 1 : -1) * nodes[n / 2], at = (low + high) / 2 + (high - low) / 2 * u;
      const auto [z2, rest, slope] = z_at(at);
      const auto [i0, missing] = bessel_in_long_double(beta * b * rest / 2);
      const real w = weights[n / 2] * (high - low) / 2 * slope * std::exp(-beta * a * z2) * i0;
      sum[0] += w;
      sum[1] += w * z2;
      sum[2] += w * rest * missing / 2;
      sum[3] += w * rest * (1 - missing / 2);
    }
  };
  const auto from_equator = [](real z) { return std::array<real, 3>{z * z, (1 - z) * (1 + z), 1}; };
  const auto from_pole = [](real rest) { return std::array<real, 3>{1 - rest, rest, 0.5L / std::sqrt(1 - rest)}; };
  const real narrow = std::min(0.25L, 0.5L / std::sqrt(1 + beta * a)), half = 0.5L;
  for (real low = 0, high = narrow; low < std::sqrt(half); low = high, high *= 1.7L)
    panel(from_equator, low, high = std::min(high, std::sqrt(half)));
  for (real low = 0, high = std::min(half, 1 / (2 + beta * b)); low < half; low = high, high *= 2)
    panel(from_pole, low, high = std::min(high, half));
  const auto mean = [&](int k) { return sum[static_cast<std::size_t>(k)] / sum[0]; };
  const real square = real(c) * c;
  return {double(square * mean(1)), double(square * mean(2)), double(square * mean(3)),
          double(a * mean(1) + b * mean(2))};
}

struct attack_count {
  int tried = 0, answered = 0, refused = 0, checked = 0, wrong = 0;
  double worst = 0;  ///< error over uncertainty
};

inline void count_answer(attack_count& count, const std::string& what, const attacked_scene& s,
                         const reference_value& found, const std::optional<second_opinion>& truth) {
  ++count.answered;
  if (!truth || !std::isfinite(truth->value)) return;
  ++count.checked;
  const double error = std::max(0.0, std::fabs(*found.value - truth->value) - truth->uncertainty);
  count.worst = std::max(count.worst, error / std::max(found.uncertainty, 1e-300));
  if (error <= 3 * found.uncertainty) return;
  ++count.wrong;
  fmt::print("wrong: {} {:.15g} +- {:.2g}, degree {}, second {:.15g} +- {:.2g}: {}\n", what, *found.value,
             found.uncertainty, found.degree, truth->value, truth->uncertainty, words(s));
}

constexpr int most_second = 450;    // unknowns of a dense block
constexpr int highest_second = 52;  // degree

inline std::optional<second_opinion> second_expectation(const attacked_scene& s, const sphere_function& f, int degree) {
  if (degree > highest_second) return std::nullopt;
  const sparse_matrix whole = backward_operator(s.problem, degree);
  Eigen::VectorXd c = harmonic_coefficients([&](const Eigen::Vector3d& x) { return f(s.problem.radius * x); }, degree);
  c = c.unaryExpr([&, least = 1e-14 * c.norm()](double x) { return std::fabs(x) < least ? 0.0 : x; });
  const auto block = blocks_of(whole, c);
  const Eigen::MatrixXd part = s.time * Eigen::MatrixXd(submatrix(whole, block));
  if (part.rows() > most_second || part.norm() > 1e6) return std::nullopt;
  const Eigen::VectorXd start = c(block), y = harmonics_at(s.start.normalized(), degree)(block);
  return second_opinion{y.dot(part.exp() * start), 1e-12 * c.norm() + 1e-16 * part.norm() * c.norm()};
}

inline std::optional<second_opinion> second_gap(const attacked_scene& s, int degree) {
  if (degree > highest_second) return std::nullopt;
  const sparse_matrix whole = backward_operator(s.problem, degree);
  const sparse_matrix rest = whole.block(1, 1, whole.rows() - 1, whole.cols() - 1);
  double slowest = -HUGE_VAL;
  for (const auto& block : connected_blocks(rest)) {
    const Eigen::MatrixXd part(submatrix(rest, block));
    if (part.rows() > most_second) return std::nullopt;
    slowest = std::max(slowest, Eigen::EigenSolver<Eigen::MatrixXd>(part, false).eigenvalues().real().maxCoeff());
  }
  return second_opinion{-slowest, 1e-15 * whole.norm()};
}

inline std::optional<second_opinion> second_mean(const attacked_scene& s, const sphere_function& f, int degree) {
  const auto& p = s.problem;
  const auto& i = p.inertia;
  if (s.isotropic && !(i[0] == i[1] && i[1] == i[2])) {
    const double beta = 2 * p.theta / p.covariance(0, 0);
    const double least = p.radius * p.radius / (2 * *std::ranges::max_element(i));
    const double value = least + gibbs_about_the_other_axis(i, p.radius, beta)[3];
    return second_opinion{value, 1e-14 * value};
  }
  if (degree > highest_second) return std::nullopt;
  const auto density = left_null_vector(backward_operator(p, degree), 2500);
  if (!density) return std::nullopt;
  const Eigen::VectorXd c = harmonic_coefficients([&](const Eigen::Vector3d& x) { return f(p.radius * x); }, degree);
  return second_opinion{c.dot(*density) / std::sqrt(4 * std::numbers::pi), 1e-12 * c.norm()};
}

inline void attack_gibbs(const attacked_scene& s, attack_count& count) {
  const auto& p = s.problem;
  auto i = p.inertia;
  if (!s.isotropic || (i[0] == i[1] && i[1] == i[2])) return;
  const double beta = 2 * p.theta / p.covariance(0, 0);
  const gibbs_law law(i, p.radius, beta);
  const auto second = gibbs_about_the_other_axis(i, p.radius, beta);
  ++count.tried;
  std::array<std::size_t, 3> order{0, 1, 2};
  std::ranges::sort(order, [&](auto a, auto b) { return i[a] < i[b]; });
  for (std::size_t k = 0; k < 4; ++k) {
    const double value = k < 3 ? law.mean_square(int(order[k])) : law.excess_energy();
    count_answer(count, fmt::format("gibbs {}", k), s, {value, law.relative_uncertainty() * std::fabs(value)},
                 second_opinion{second[k], 1e-15 * second[k]});
  }
}

/// Asks and checks one quantity: gibbs, mean, expectation, gap or lyapunov.
inline void attack(const std::string& quantity, const attacked_scene& s, attack_count& count) {
  if (quantity == "gibbs") return attack_gibbs(s, count);
  const auto& p = s.problem;
  const auto f = *named_observable("energy", p.inertia);
  const double size = f(s.start), rate = p.covariance.trace();
  reference_value found;
  if (quantity == "mean") found = stationary_mean(p, f, 1e-11 * size);
  if (quantity == "expectation") found = expectation(p, f, s.start, s.time, 1e-11 * size);
  if (quantity == "gap") found = spectral_gap(p, 1e-9 * rate);
  if (quantity == "lyapunov") {
    const auto [least, most] = std::ranges::minmax(p.inertia);
    const auto answer = lyapunov(p, 1e-6 * p.radius / least);
    found = {answer.lambda1, answer.uncertainty, answer.degree, answer.reason};
  }
  ++count.tried;
  if (!found.value || (!found.reason.empty() && found.uncertainty > 0.1 * std::fabs(*found.value))) {
    ++count.refused;
    return;
  }
  std::optional<second_opinion> truth;
  if (quantity == "mean") truth = second_mean(s, f, 2 * found.degree + 4);
  if (quantity == "expectation") truth = second_expectation(s, f, 2 * found.degree + 4);
  if (quantity == "gap" && found.degree > 0)
    truth = second_gap(s, found.degree > 20 ? found.degree * 5 / 4 : 2 * found.degree + 4);
  if (quantity == "lyapunov" && found.degree <= 10) {
    const auto higher = lyapunov(p, 1e-12 * p.radius, found.degree + 6);
    if (higher.lambda1) truth = second_opinion{*higher.lambda1, 1e-13 * p.radius};
  }
  count_answer(count, quantity, s, found, truth);
}

inline std::string attack_table(const std::map<std::string, attack_count>& counts) {
  std::string text = "quantity      tried  answered  refused  checked  wrong  honest      worst error/bar\n";
  for (const auto& [name, n] : counts)
    text += fmt::format("{:<12} {:>6} {:>9} {:>8} {:>8} {:>6}  {:.3f} %   {:.2g}\n", name, n.tried, n.answered,
                        n.refused, n.checked, n.wrong, 100.0 * (1 - double(n.wrong) / std::max(1, n.checked)), n.worst);
  return text;
}

}  // namespace polhode::test
