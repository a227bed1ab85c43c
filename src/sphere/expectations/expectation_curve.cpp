// SPDX-License-Identifier: Apache-2.0
#include "sphere/expectations/expectation_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "algebra/exponential_action.hpp"
#include "sphere/expectations/expectation.hpp"
#include "sphere/harmonics/backward_operator.hpp"
#include "sphere/harmonics/harmonics.hpp"

namespace polhode {
namespace {

constexpr std::array curve_degrees{8, 12, 16, 24, 32, 48, 64};
constexpr int fewest_nodes = 16, most_nodes = 1024;
constexpr double affordable = 1e10;       // multiplications
constexpr double curve_rounding = 1e-14;  // of a function's size

/// cos(pi j / n), j = 0..n, as times from 0 on.
double node_time(double j, int n, double time) { return time * (1 - std::cos(std::numbers::pi * j / n)) / 2; }

/// The nodes, and between them three times at which a polynomial through the nodes is tried: a fast oscillation can
/// look slow at all nodes.
struct grid {
  std::vector<double> times;
  std::vector<Eigen::Index> nodes, between;  // of them, in their order
  grid(int n, double time) {
    for (int j = 0; j <= n; ++j) {
      nodes.push_back(std::ssize(times));
      times.push_back(node_time(j, n, time));
      if (j != n / 5 && j != n / 2 && j != 5 * n / 6) continue;
      between.push_back(std::ssize(times));
      times.push_back(node_time(j + 0.5, n, time));
    }
  }
};

/// Values at increasing times from 0 on [time][function], on harmonics up to a degree; nothing where that is not
/// affordable.
std::optional<Eigen::MatrixXd> values_at(const sphere_problem& problem, const sparse_matrix& forward,
                                         const Eigen::MatrixXd& functions, const Eigen::Vector3d& start,
                                         const std::vector<double>& times) {
  const int degree = static_cast<int>(std::lround(std::sqrt(static_cast<double>(forward.rows())))) - 1;
  double products = 0;
  for (std::size_t j = 1; j < times.size(); ++j)
    products += exponential_action_products(forward, times[j] - times[j - 1]);
  if (products * static_cast<double>(forward.nonZeros()) > affordable) return std::nullopt;
  Eigen::VectorXd law = harmonics_at(start / problem.radius, degree);
  Eigen::MatrixXd out(times.size(), functions.cols());
  for (std::size_t j = 0; j < times.size(); ++j) {
    if (j > 0) law = exponential_action(forward, times[j] - times[j - 1], law);
    out.row(static_cast<Eigen::Index>(j)) = law.transpose() * functions;
  }
  return out;
}

/// Of the polynomial through values at the nodes: sum_k c_k cos(k pi j / n), ends halved. t runs from x = 1 to -1.
Eigen::MatrixXd chebyshev_coefficients(const Eigen::MatrixXd& values) {
  const auto n = static_cast<int>(values.rows()) - 1;
  Eigen::MatrixXd cosines(n + 1, n + 1);
  for (int k = 0; k <= n; ++k)
    for (int j = 0; j <= n; ++j) {
      const double ends = (k == 0 || k == n ? 0.5 : 1) * (j == 0 || j == n ? 0.5 : 1);
      cosines(k, j) = 2.0 / n * ends * std::cos(std::numbers::pi * ((k * j) % (2 * n)) / n);
    }
  return cosines * values;
}

/// How large the last eighth of the coefficients still is.
Eigen::VectorXd tail_of(const Eigen::MatrixXd& coefficients) {
  return coefficients.bottomRows(coefficients.rows() / 8).cwiseAbs().colwise().sum();
}

/// By the reference of one time and one function; not finite where that has no answer.
Eigen::VectorXd distance_at_the_horizon(const expectation_curve& found, const sphere_problem& problem,
                                        std::span<const sphere_function> functions, const Eigen::VectorXd& scale,
                                        const Eigen::Vector3d& start, double time, double accuracy) {
  Eigen::VectorXd out = found.at(time);
  for (Eigen::Index i = 0; i < out.size(); ++i) {
    const auto one = expectation(problem, functions[static_cast<std::size_t>(i)], start, time, accuracy * scale[i]);
    out[i] = one.value ? std::fabs(out[i] - *one.value) + one.uncertainty : HUGE_VAL;
  }
  return out;
}

/// What one degree answers: values of every function at the nodes, coefficients, and how far off they are: between the
/// nodes, or as far as they still matter at the end.
struct answer {
  Eigen::MatrixXd values, coefficients;
  Eigen::VectorXd off;
};

answer answer_from(const grid& g, const Eigen::MatrixXd& values, double time) {
  answer out{values(g.nodes, Eigen::all), {}, Eigen::VectorXd::Zero(values.cols())};
  out.coefficients = chebyshev_coefficients(out.values);
  const expectation_curve curve(time, out.coefficients, out.off, "");
  for (const auto at : g.between)
    out.off =
        out.off.cwiseMax((curve.at(g.times[static_cast<std::size_t>(at)]) - values.row(at).transpose()).cwiseAbs());
  out.off = out.off.cwiseMax(tail_of(out.coefficients));
  return out;
}

/// Doubles the nodes until that is small; `nodes` remembers how many that took.
std::optional<answer> answer_at(const sphere_problem& problem, std::span<const sphere_function> functions,
                                const Eigen::VectorXd& least, const Eigen::Vector3d& start, double time, int degree,
                                int& nodes) {
  Eigen::MatrixXd coefficients(harmonic_count(degree), static_cast<Eigen::Index>(functions.size()));
  for (std::size_t i = 0; i < functions.size(); ++i)
    coefficients.col(static_cast<Eigen::Index>(i)) =
        harmonic_coefficients([&](const Eigen::Vector3d& x) { return functions[i](problem.radius * x); }, degree);
  const sparse_matrix forward = backward_operator(problem, degree).transpose();
  for (;; nodes *= 2) {
    const grid g(nodes, time);
    const auto values = values_at(problem, forward, coefficients, start, g.times);
    if (!values || !values->allFinite()) return std::nullopt;
    auto out = answer_from(g, *values, time);
    if ((out.off.array() <= least.array()).all() || nodes >= most_nodes) return out;
  }
}

}  // namespace

Eigen::VectorXd expectation_curve::at(double t) const {
  const double x = 1 - 2 * std::clamp(t / time_, 0.0, 1.0);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(coefficients_.cols()), before = b;
  for (Eigen::Index k = coefficients_.rows() - 1; k > 0; --k) {
    const Eigen::VectorXd next = coefficients_.row(k).transpose() + 2 * x * b - before;
    before = b;
    b = next;
  }
  return coefficients_.row(0).transpose() + x * b - before;
}

expectation_curve expectations(const sphere_problem& problem, std::span<const sphere_function> functions,
                               const Eigen::VectorXd& scale, const Eigen::Vector3d& start, double time,
                               double accuracy) {
  const Eigen::VectorXd least = std::max(accuracy, curve_rounding) * scale;
  const auto none = Eigen::VectorXd::Constant(scale.size(), HUGE_VAL);
  Eigen::VectorXd change = none, earlier = none;
  std::optional<answer> last;
  int nodes = fewest_nodes;
  for (const int degree : curve_degrees) {
    auto next = answer_at(problem, functions, least, start, time, degree, nodes);
    if (!next) break;
    earlier = change;
    change = last && last->values.rows() == next->values.rows()
                 ? Eigen::VectorXd((next->values - last->values).cwiseAbs().colwise().maxCoeff().transpose())
                 : Eigen::VectorXd(none);
    last = std::move(next);
    if ((change.array() <= least.array()).all() && (earlier.array() <= least.array()).all()) break;
  }
  if (!last) return {time, Eigen::MatrixXd::Zero(1, scale.size()), none, "no affordable degree answers"};
  const expectation_curve found(time, last->coefficients, none, "");
  const Eigen::VectorXd uncertainty = change.cwiseMax(curve_rounding * scale) + last->off +
                                      distance_at_the_horizon(found, problem, functions, scale, start, time, accuracy);
  const bool converged = (uncertainty.array() <= 10 * least.array()).all();
  return {time, last->coefficients, uncertainty,
          converged ? ""
                    : fmt::format("known to {:.1e} of an observable's size only",
                                  (uncertainty.array() / scale.array()).maxCoeff())};
}

}  // namespace polhode
