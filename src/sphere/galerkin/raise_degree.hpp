// SPDX-License-Identifier: Apache-2.0
// How every reference by projection decides its degree.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sphere/galerkin/reference_value.hpp"

namespace polhode {

constexpr double unbounded = std::numeric_limits<double>::infinity();

struct projected_value {
  double value;
  double floor;              ///< its rounding error, which no tolerance undercuts
  double bound = unbounded;  ///< of its error, proved
  bool resolved = true;      ///< if not, agreement with other degrees says nothing
};

struct accuracy {
  double absolute;
  double relative = unbounded;  ///< of the value
  double size = 0;              ///< what agreement is measured by, besides the value; 0: only a proved bound counts
  double unit = 1;              ///< what all of it is counted in, for words
};

/// needed: about the degree that would do; see needed_degree.
inline std::string not_converged(double tolerance, int degree, double needed) {
  std::string text = fmt::format("not converged to {:.1g}: ", tolerance);
  text += degree > 0 ? fmt::format("degree {} is the last that is affordable", degree) : "no affordable degree answers";
  if (!(needed > std::max(1, 2 * degree))) return text;  // within what the rule is worth
  if (!std::isfinite(needed)) return text + ", and none would do";
  const double unit = std::pow(10, std::floor(std::log10(needed)) - 1);  // two digits: it is a rule of thumb
  return text + fmt::format(", and about {:.0f} would be needed", unit * std::round(needed / unit));
}

/// The degrees to try: the automatic ones, or the wanted one and two lower ones that tell how much it still changes.
inline std::vector<int> degrees_to_try(std::span<const int> automatic, int wanted) {
  if (wanted == 0) return {automatic.begin(), automatic.end()};
  std::vector<int> degrees{wanted};
  for (int lower = 0; lower < 2 && degrees.front() > 1; ++lower)
    degrees.insert(degrees.begin(), std::max(1, degrees.front() - std::max(2, degrees.front() / 4)));
  return degrees;
}

/// Three successive answers, as one uncertainty. Projections converge geometrically, and the degrees grow by half at
/// most: errors fall like e, e^1.5, e^2.25, in units of the size. So the last change must be small, and the one before
/// small enough for it: where the last is small by accident or symmetry, the one before tells. Changes that do not
/// even halve are those of no geometric series: many more of them may follow.
class three_agree {
 public:
  /// What the first two and the last change say of the last answer; infinite until there are three.
  double uncertainty(double change, double size) {
    const double before = change_;
    change_ = change;
    if (before == unbounded) return unbounded;
    const double to_follow = change > before / 2 ? many * std::max(change, before) : change;
    return std::max(to_follow, size * std::pow(before / std::max(size, 1e-300), 1.5));
  }

 private:
  static constexpr double many = 10;
  double change_ = unbounded;
};

/// Of the degree that the width of the noise asks for: below it, agreement is worth nothing, as what is not resolved at
/// all agrees too.
constexpr double needed_share = 0.25;

/// Raises the degree until the uncertainty is what is asked for: the proved bound where there is one, else what three
/// successive answers say, from the needed share of the needed degree on. value_at(degree) is an optional
/// projected_value, empty where that degree is not affordable. A wanted degree is the one that answers.
template <class ValueAt>
reference_value raise_degree(std::span<const int> degrees, const accuracy& asked, double needed,
                             const ValueAt& value_at, int wanted = 0) {
  reference_value last;
  three_agree agreement;
  const bool comparable = asked.size > 0 && degrees.back() >= needed_share * needed;
  double previous = std::numeric_limits<double>::quiet_NaN();
  for (const int degree : degrees) {
    const std::optional<projected_value> found = value_at(degree);
    if (!found || !std::isfinite(found->value)) break;
    const double change = std::fabs(found->value - previous);
    double agreed =
        agreement.uncertainty(std::isnan(change) ? unbounded : change, std::max(asked.size, std::fabs(found->value)));
    if (!comparable || !found->resolved || degree < needed_share * needed) agreed = unbounded;
    previous = found->value;
    const double uncertainty = std::max(std::min(agreed, found->bound), found->floor);
    last = {.value = found->value, .uncertainty = uncertainty, .degree = degree, .reason = {}};
    const double enough = std::min(asked.absolute, asked.relative * std::fabs(found->value));
    if (degree >= wanted && uncertainty <= std::max(enough, found->floor)) return last;
    if (asked.size > 0 && !comparable && degree >= degrees[degrees.size() / 3]) break;  // out of reach: the bound alone
  }
  const double enough = std::min(asked.absolute, asked.relative * std::fabs(last.value.value_or(unbounded)));
  last.reason =
      not_converged(enough * asked.unit, comparable || asked.size == 0 ? last.degree : degrees.back(), needed);
  if (!std::isfinite(last.uncertainty))
    last = {.value = {}, .uncertainty = 0, .degree = last.degree, .reason = last.reason};
  return last;
}

}  // namespace polhode
