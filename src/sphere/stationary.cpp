// SPDX-License-Identifier: Apache-2.0
#include "sphere/stationary.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "algebra/sparse_blocks.hpp"
#include "sphere/galerkin/poisson.hpp"
#include "sphere/galerkin/raise_degree.hpp"
#include "sphere/harmonics/backward_operator.hpp"
#include "sphere/harmonics/harmonics.hpp"
#include "sphere/harmonics/observables.hpp"
#include "sphere/uniqueness.hpp"

namespace polhode {
namespace {

constexpr std::array law_degrees{8, 12, 16, 24, 32, 48, 64, 96};
constexpr int most_unknowns_of_law = 5000;  // unknowns in a block: seconds

std::string no_one_law(const sphere_problem& problem) {
  if (!problem.has_noise()) return "no noise: every attractor carries a stationary law, and none has a density";
  return no_unique_law(problem);
}

reference_value stationary_mean_of(const sphere_problem& problem, const sphere_function& f, accuracy asked,
                                   int wanted) {
  const auto value_at = [&](int degree) {
    const auto [c, cut_off] = cut_to(problem, f, degree);
    const projected_value uniform{c[0], 0, 0};
    auto found = has_uniform_law(problem)
                     ? std::optional(uniform)
                     : poisson_mean(tall_backward_operator(problem, degree), c, most_unknowns_of_law,
                                    [](const Eigen::VectorXd& r) { return harmonic_supremum(r); });
    if (found) {
      found->value /= unit_of_mean;
      found->floor = std::max(found->floor, rounding_of_sums * c.norm() / unit_of_mean);
      found->bound += cut_off + found->floor;
    }
    return found;
  };
  asked.size = observable_coefficients(problem, f, law_degrees[0]).norm() / unit_of_mean;
  const double needed = has_uniform_law(problem) ? 0 : needed_degree(problem);
  return raise_degree(degrees_to_try(law_degrees, wanted), asked, needed, value_at, wanted);
}

}  // namespace

stationary_law stationary(const sphere_problem& problem, double tolerance, int wanted) {
  if (const auto reason = no_one_law(problem); !reason.empty()) return {.reason = reason};
  if (has_uniform_law(problem)) {
    const int degree = wanted > 0 ? wanted : law_degrees[0];
    const Eigen::VectorXd uniform = Eigen::VectorXd::Unit(harmonic_count(degree), 0) / unit_of_mean;
    return {.density = uniform, .change = 0 * uniform, .uncertainty = 0, .degree = degree, .reason = {}};
  }
  const double needed = needed_degree(problem);
  stationary_law last;
  three_agree agreement;
  for (const int degree : degrees_to_try(law_degrees, wanted)) {
    auto density = left_null_vector(backward_operator(problem, degree), most_unknowns_of_law);
    if (!density) break;
    *density /= unit_of_mean;  // integral one
    Eigen::VectorXd change = *density;
    const bool first = !last.density;
    if (!first) change.head(last.density->size()) -= *last.density;
    const double size = density->norm(), floor = 1e-15 * size;
    const double agreed = agreement.uncertainty(first ? unbounded : change.norm(), size);
    const double distance = std::max({agreed, change.norm(), floor});
    last = {.density = std::move(density), .change = change, .uncertainty = distance, .degree = degree, .reason = {}};
    if (degree >= needed_share * needed && distance <= std::max(tolerance, 10 * floor)) return last;
  }
  last.reason = not_converged(tolerance, last.degree, needed);
  return last;
}

reference_value mean(const sphere_problem& problem, const stationary_law& law, const sphere_function& f) {
  if (!law.density) return {.degree = law.degree, .reason = law.reason};
  const Eigen::VectorXd c = observable_coefficients(problem, f, law.degree);
  const double changed = law.change.norm();
  const double uncertain = changed > 0 ? std::fabs(c.dot(law.change)) * std::max(1.0, law.uncertainty / changed)
                                       : law.uncertainty * c.norm();  // nothing tells in which functions
  return {.value = c.dot(*law.density),
          .uncertainty = std::max(uncertain, rounding_of_sums * c.norm()),
          .degree = law.degree,
          .reason = law.reason};
}

reference_value stationary_mean(const sphere_problem& problem, const sphere_function& f, double tolerance, int wanted) {
  if (const auto reason = no_one_law(problem); !reason.empty()) return {.reason = reason};
  return in_its_unit(problem, f, [&](const sphere_function& g, double unit) {
    return stationary_mean_of(problem, g, {.absolute = tolerance / unit, .unit = unit}, wanted);
  });
}

}  // namespace polhode
