// SPDX-License-Identifier: Apache-2.0
// Observables in harmonics, and in a unit of their own, so that the squares of them that bars are made of stay within
// double precision.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "sphere/galerkin/reference_value.hpp"
#include "sphere/sphere_problem.hpp"

namespace polhode {

inline constexpr const char* leaves_double_precision =
    "the observable leaves double precision on this sphere: another unit of momentum would be needed";

inline constexpr double rounding_of_sums = 1e-14;  ///< over the norm of what is added up

/// Coefficients of f(radius x); what is rounding only is left out, as it would tie together blocks that do not talk to
/// each other.
Eigen::VectorXd observable_coefficients(const sphere_problem& problem, const sphere_function& f, int degree);

struct cut_function {
  Eigen::VectorXd coefficients;
  double cut_off;  ///< about the supremum of what the degree cuts off: its next two degrees
};
/// To harmonics up to the degree.
cut_function cut_to(const sphere_problem& problem, const sphere_function& f, int degree);

/// A power of two, so that dividing by it rounds nothing: about the largest harmonic coefficient of f up to degree 8.
/// Nothing where that is not finite or below 1e-290, of which no bar could be told.
std::optional<double> unit_of(const sphere_problem& problem, const sphere_function& f);
std::optional<double> unit_of(const Eigen::VectorXd& coefficients);  ///< of all that count

/// ask(f / unit, unit), counted in the unit of f again.
template <class Ask>
reference_value in_its_unit(const sphere_problem& problem, const sphere_function& f, const Ask& ask) {
  const auto unit = unit_of(problem, f);
  if (!unit) return {.reason = leaves_double_precision};
  reference_value found = ask(sphere_function([&](const Eigen::Vector3d& pi) { return f(pi) / *unit; }), *unit);
  if (found.value) *found.value *= *unit;
  found.uncertainty *= *unit;
  return found;
}

}  // namespace polhode
