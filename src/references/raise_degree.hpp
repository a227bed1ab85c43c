// How every reference by projection decides its degree.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>

#include "references/kolmogorov.hpp"

namespace polhode {

struct projected_value {
  double value;
  double floor;  ///< its rounding error, which no tolerance undercuts
};

inline std::string not_converged(double tolerance, int degree) {
  return fmt::format("not converged to {:g} at degree {}, the last that is affordable", tolerance, degree);
}

/// Raises the degree until two successive values agree to the tolerance; their difference is the uncertainty.
/// value_at(degree) is an optional projected_value, empty where that degree is not affordable.
template <class ValueAt>
reference_value raise_degree(std::span<const int> degrees, double tolerance, const ValueAt& value_at) {
  reference_value last;
  int seen = 0;
  for (const int degree : degrees) {
    const std::optional<projected_value> found = value_at(degree);
    if (!found || !std::isfinite(found->value)) break;
    const double change = seen++ == 0 ? HUGE_VAL : std::fabs(found->value - *last.value);
    last = {.value = found->value, .uncertainty = std::max(change, found->floor), .degree = degree, .reason = {}};
    if (last.uncertainty <= std::max(tolerance, found->floor)) return last;
  }
  last.reason = not_converged(tolerance, last.degree);
  if (seen < 2) last = {.value = {}, .uncertainty = 0, .degree = last.degree, .reason = last.reason};
  return last;
}

}  // namespace polhode
