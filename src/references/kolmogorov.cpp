#include "references/kolmogorov.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "references/deterministic.hpp"
#include "references/exponential_action.hpp"
#include "references/raise_degree.hpp"
#include "references/sparse_blocks.hpp"

namespace polhode {
namespace {

constexpr std::array degrees{8, 12, 16, 24, 32, 48, 64, 96, 128};
constexpr double affordable = 1e10;  // multiplications
constexpr double rounding = 1e-14;   // of what is added up
constexpr double long_ago = 60;      // relaxation times: exp(-60) hides any constant before it

// Coefficients of a smooth function that are rounding only would tie together blocks that do not talk to each other.
Eigen::VectorXd observable_coefficients(const sphere_problem& problem, const sphere_function& f, int degree) {
  Eigen::VectorXd c = harmonic_coefficients([&](const Eigen::Vector3d& x) { return f(problem.radius * x); }, degree);
  const double least = rounding * c.norm();
  return c.unaryExpr([&](double x) { return std::fabs(x) < least ? 0 : x; });
}

/// The stationary mean, where by then every other mode has died; the rate of noise bounds the cost of asking.
std::optional<reference_value> expectation_long_after(const sphere_problem& problem, const sphere_function& f,
                                                      double time, double tolerance, int wanted) {
  if (time * problem.covariance.trace() < long_ago) return std::nullopt;
  const auto gap = spectral_gap(problem, 1e-3 * problem.covariance.trace());
  if (!gap.converged() || *gap.value * time < long_ago || gap.uncertainty > 0.1 * *gap.value) return std::nullopt;
  auto late = mean(problem, stationary(problem, tolerance, wanted), f);
  if (!late.converged()) return std::nullopt;
  late.forgotten = true;
  return late;
}

}  // namespace

std::optional<sphere_function> named_observable(std::string_view name, const std::array<double, 3>& inertia) {
  using pi_type = const Eigen::Vector3d&;
  if (name == "energy")
    return [i = Eigen::Array3d(inertia.data())](pi_type pi) { return 0.5 * (pi.array().square() / i).sum(); };
  if (name == "casimir") return [](pi_type pi) { return 0.5 * pi.squaredNorm(); };
  if (name == "exp(pi3)") return [](pi_type pi) { return std::exp(pi[2]); };
  for (int k = 0; k < 3; ++k) {
    if (name == fmt::format("pi{}", k + 1)) return [k](pi_type pi) { return pi[k]; };
    if (name == fmt::format("pi{}^2", k + 1)) return [k](pi_type pi) { return pi[k] * pi[k]; };
  }
  return std::nullopt;
}

sparse_matrix backward_operator(const sphere_problem& problem, int degree) {
  const int inside = degree + 1;  // so that products of two coordinates are exact up to the degree
  const auto x = coordinates(inside);
  const auto turn = rotation_generators(inside);
  sparse_matrix generator(harmonic_count(inside), harmonic_count(inside));
  const double c = problem.radius;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const double skew = problem.theta * c * c * (1 / problem.inertia[k] - 1 / problem.inertia[j]);
    const sparse_matrix a = c / problem.inertia[i] * x[i] + skew * sparse_matrix(x[j] * x[k]);
    generator -= sparse_matrix(a * turn[i]);
    for (std::size_t l = 0; l < 3; ++l) {
      const double q = problem.covariance(long(i), long(l));
      if (q != 0) generator += 0.5 * q * sparse_matrix(turn[i] * turn[l]);
    }
  }
  sparse_matrix corner = generator.block(0, 0, harmonic_count(degree), harmonic_count(degree));
  corner.prune(corner.coeffs().cwiseAbs().maxCoeff(), 1e-15);  // what cancelled
  return corner;
}

double needed_degree(const sphere_problem& problem) {
  const auto [least, most] = std::ranges::minmax(problem.inertia);
  const double c = problem.radius, shear = c * std::hypot(1, problem.theta * c) * (1 / least - 1 / most);
  return 10 * std::sqrt(3 * shear / problem.covariance.trace());
}

reference_value expectation(const sphere_problem& problem, const sphere_function& f, const Eigen::Vector3d& start,
                            double time, double tolerance, int wanted) {
  if (problem.covariance.isZero(0)) return on_the_path(problem, f, start, time);
  if (auto late = expectation_long_after(problem, f, time, tolerance, wanted)) return *late;
  const double needed = needed_degree(problem);
  const auto value_at = [&](int degree) -> std::optional<projected_value> {
    const Eigen::VectorXd coefficients = observable_coefficients(problem, f, degree);
    const sparse_matrix whole = backward_operator(problem, degree);
    const index_set block = blocks_of(whole, coefficients);
    const sparse_matrix part = submatrix(whole, block);
    if (exponential_action_products(part, time) * static_cast<double>(part.nonZeros()) > affordable) return {};
    const Eigen::VectorXd y = harmonics_at(start.normalized(), degree)(block);
    return projected_value{y.dot(exponential_action(part, time, coefficients(block))),
                           rounding * coefficients.norm() / std::sqrt(4 * std::numbers::pi)};
  };
  return raise_degree(degrees_to_try(degrees, wanted), tolerance, needed, value_at);
}

reference_value mean(const sphere_problem& problem, const stationary_law& law, const sphere_function& f) {
  if (!law.density) return {.degree = law.degree, .reason = law.reason};
  const Eigen::VectorXd c = observable_coefficients(problem, f, law.degree);
  return {.value = c.dot(*law.density),
          .uncertainty = std::max(std::fabs(c.dot(law.change)), rounding * c.norm()),
          .degree = law.degree,
          .reason = law.reason};
}

}  // namespace polhode
