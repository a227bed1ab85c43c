// How every reference by projection decides its degree.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "references/kolmogorov.hpp"

namespace polhode {

struct projected_value {
  double value;
  double floor;  ///< its rounding error, which no tolerance undercuts
};

/// needed: about the degree that would do; see needed_degree.
inline std::string not_converged(double tolerance, int degree, double needed) {
  std::string text = fmt::format("not converged to {:.1g}: ", tolerance);
  text += degree > 0 ? fmt::format("degree {} is the last that is affordable", degree) : "no affordable degree answers";
  if (!(needed > 2 * degree)) return text;                               // within what the rule is worth
  const double unit = std::pow(10, std::floor(std::log10(needed)) - 1);  // two digits: it is a rule of thumb
  return text + fmt::format(", and about {:.0f} would be needed", unit * std::round(needed / unit));
}

/// The degrees to try: the automatic ones, or the wanted one and a lower one that tells how much it still changes.
inline std::vector<int> degrees_to_try(std::span<const int> automatic, int wanted) {
  if (wanted == 0) return {automatic.begin(), automatic.end()};
  return {std::max(1, wanted - std::max(2, wanted / 4)), wanted};
}

/// Raises the degree until two successive values agree to the tolerance; their difference is the uncertainty.
/// value_at(degree) is an optional projected_value, empty where that degree is not affordable.
template <class ValueAt>
reference_value raise_degree(std::span<const int> degrees, double tolerance, double needed, const ValueAt& value_at) {
  reference_value last;
  int seen = 0;
  for (const int degree : degrees) {
    const std::optional<projected_value> found = value_at(degree);
    if (!found || !std::isfinite(found->value)) break;
    const double change = seen++ == 0 ? HUGE_VAL : std::fabs(found->value - *last.value);
    last = {.value = found->value, .uncertainty = std::max(change, found->floor), .degree = degree, .reason = {}};
    if (last.uncertainty <= std::max(tolerance, found->floor)) return last;
  }
  last.reason = not_converged(tolerance, last.degree, needed);
  if (seen < 2) last = {.value = {}, .uncertainty = 0, .degree = last.degree, .reason = last.reason};
  return last;
}

}  // namespace polhode
