#include "sphere/expectations/expectation.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "algebra/exponential_action.hpp"
#include "algebra/sparse_blocks.hpp"
#include "sphere/expectations/deterministic.hpp"
#include "sphere/galerkin/poisson.hpp"
#include "sphere/galerkin/raise_degree.hpp"
#include "sphere/harmonics/backward_operator.hpp"
#include "sphere/harmonics/harmonics.hpp"
#include "sphere/harmonics/observables.hpp"
#include "sphere/spectral_gap.hpp"
#include "sphere/stationary.hpp"

namespace polhode {
namespace {

constexpr std::array degrees{8, 12, 16, 24, 32, 48, 64, 96, 128};
constexpr double affordable = 1e10;  // multiplications
constexpr double in_hope = 0.05;     // of that, where it ends only if the start is forgotten
constexpr double long_ago = 60;      // relaxation times: exp(-60) hides any constant before it

/// The stationary mean, where by then every other mode has died; the rate of noise bounds the cost of asking.
std::optional<reference_value> expectation_long_after(const sphere_problem& problem, const sphere_function& f,
                                                      double time, double tolerance, int wanted) {
  if (time * noise_rate(problem) < long_ago) return std::nullopt;
  const auto gap = spectral_gap(problem, unbounded);
  if (!gap.converged() || (*gap.value - gap.uncertainty) * time < long_ago) return std::nullopt;
  auto late = stationary_mean(problem, f, tolerance, wanted);
  if (!late.converged()) return std::nullopt;
  late.forgotten = true;
  return late;
}

struct propagated_value {
  projected_value found;
  bool relaxed;  ///< before the time was over
};

/// exp(time A) f at y. The remainder (A - A_L) g of the Galerkin solution g, summed over the time, bounds its error.
/// Once g is a constant but for rounding it stays one, as the semigroup is a contraction: there it ends.
std::optional<propagated_value> propagated(const sparse_matrix& tall, const cut_function& cut, const Eigen::VectorXd& y,
                                           double time, int degree) {
  const Eigen::VectorXd& f = cut.coefficients;
  const sparse_matrix whole = tall.topRows(tall.cols());
  const index_set block = blocks_of(whole, f);
  const sparse_matrix part = submatrix(whole, block);
  const double cost = exponential_action_products(part, time) * static_cast<double>(part.nonZeros());
  const double hoped = cost > affordable ? time * in_hope * affordable / cost : time;  // it may relax by then
  const sparse_matrix beyond = columns_of(tall, block).bottomRows(tall.rows() - tall.cols());
  const auto remainder = [&](const Eigen::VectorXd& g) { return harmonic_supremum(beyond * g, degree + 1); };
  Eigen::VectorXd varying = Eigen::VectorXd::Zero(f.size());
  const double least = rounding_of_sums * f.norm() / unit_of_mean;
  const Eigen::VectorXd start = f(block);
  double before = remainder(start), bound = 0, steps = 0, passed = 0, apart = unbounded;
  const auto g = exponential_action(part, time, start, [&](const Eigen::VectorXd& now, double dt) {
    const double after = remainder(now);
    bound += dt * std::max(std::exchange(before, after), after);
    passed += dt;
    ++steps;
    varying(block) = now;
    varying[0] = 0;
    apart = harmonic_supremum(varying);
    return apart > least && passed <= hoped;
  });
  const bool relaxed = apart <= least && passed < (1 - 1e-9) * time;
  if (!relaxed && cost > affordable) return {};
  const double floor = least * std::max(1.0, std::sqrt(steps) / 10);
  return propagated_value{{y(block).dot(g), floor, bound + cut.cut_off + 2 * (relaxed ? apart : 0) + floor}, relaxed};
}

reference_value expectation_of(const sphere_problem& problem, const sphere_function& f, const Eigen::Vector3d& start,
                               double time, accuracy asked, int wanted) {
  bool relaxed = false;
  const auto value_at = [&](int degree) -> std::optional<projected_value> {
    const auto at = propagated(tall_backward_operator(problem, degree), cut_to(problem, f, degree),
                               harmonics_at(start.normalized(), degree), time, degree);
    if (!at) return {};
    relaxed = at->relaxed;
    return at->found;
  };
  // Where three degrees can tell they may: the proved bound grows with time, the error need not.
  const double needed = needed_degree(problem);
  const bool comparable = degrees.back() >= needed_share * needed;
  if (comparable) asked.size = observable_coefficients(problem, f, degrees.front()).norm() / unit_of_mean;
  const std::vector<int> chosen{wanted};
  auto found = raise_degree(wanted > 0 ? std::span<const int>(chosen) : degrees, asked, needed, value_at, wanted);
  found.relaxed = relaxed;
  if (found.converged()) return found;
  const auto late = expectation_long_after(problem, f, time, asked.absolute, wanted);
  return late ? *late : found;
}

}  // namespace

reference_value expectation(const sphere_problem& problem, const sphere_function& f, const Eigen::Vector3d& start,
                            double time, double tolerance, int wanted) {
  if (!problem.has_noise()) return on_the_path(problem, f, start, time);
  return in_its_unit(problem, f, [&](const sphere_function& g, double unit) {
    return expectation_of(problem, g, start, time, {.absolute = tolerance / unit, .unit = unit}, wanted);
  });
}

}  // namespace polhode
