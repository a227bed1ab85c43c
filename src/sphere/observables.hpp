// Observables in a unit of their own, so that the squares of them that bars are made of stay within double precision.
#pragma once

#include <optional>

#include "sphere/kolmogorov.hpp"

namespace polhode {

inline constexpr const char* leaves_double_precision =
    "the observable leaves double precision on this sphere: another unit of momentum would be needed";

/// A power of two, so that dividing by it rounds nothing: about the largest harmonic coefficient of f up to degree 8.
/// Nothing where that is not finite or below 1e-290, of which no bar could be told.
std::optional<double> unit_of(const sphere_problem& problem, const sphere_function& f);

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
