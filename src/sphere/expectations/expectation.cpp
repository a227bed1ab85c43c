// SPDX-License-Identifier: Apache-2.0
#include "sphere/expectations/expectation.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "sphere/expectations/deterministic.hpp"
#include "sphere/galerkin/propagation.hpp"
#include "sphere/galerkin/raise_degree.hpp"
#include "sphere/harmonics/backward_operator.hpp"
#include "sphere/harmonics/harmonics.hpp"
#include "sphere/harmonics/observables.hpp"
#include "sphere/spectral_gap.hpp"
#include "sphere/stationary.hpp"

namespace polhode {
namespace {

constexpr std::array expectation_degrees{8, 12, 16, 24, 32, 48, 64, 96, 128};
constexpr double long_ago = 60;  // relaxation times: exp(-60) hides any constant before it

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

reference_value expectation_of(const sphere_problem& problem, const sphere_function& f, const Eigen::Vector3d& start,
                               double time, accuracy asked, int wanted) {
  bool relaxed = false;
  const auto value_at = [&](int degree) -> std::optional<projected_value> {
    const auto cut = cut_to(problem, f, degree);
    const suprema_of_basis suprema{[](const Eigen::VectorXd& g) { return harmonic_supremum(g); },
                                   [=](const Eigen::VectorXd& g) { return harmonic_supremum(g, degree + 1); },
                                   unit_of_mean};
    auto at = propagated(tall_backward_operator(problem, degree), cut.coefficients,
                         harmonics_at(start.normalized(), degree), time, suprema);
    if (!at) return {};
    relaxed = at->relaxed;
    at->found.bound += cut.cut_off;
    return at->found;
  };
  // Where three degrees can tell they may: the proved bound grows with time, the error need not.
  const double needed = needed_degree(problem);
  const bool comparable = expectation_degrees.back() >= needed_share * needed;
  if (comparable) asked.size = observable_coefficients(problem, f, expectation_degrees.front()).norm() / unit_of_mean;
  const std::vector<int> chosen{wanted};
  auto found =
      raise_degree(wanted > 0 ? std::span<const int>(chosen) : expectation_degrees, asked, needed, value_at, wanted);
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
