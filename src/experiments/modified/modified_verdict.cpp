// SPDX-License-Identifier: Apache-2.0
#include "experiments/modified/modified_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "statistics/orders/power_series.hpp"

namespace polhode {
namespace {

constexpr double narrow_parameter = 1e-4;  // half-width, of a parameter at the coarsest dt

// Half-width of the coefficients of the residual's square y^2, which is to be as narrow as what is known of y allows: a
// residual of `narrow_parameter` at dt = 0 shows; and as the levels are known to a share u = unseen_share of themselves
// at best, their squares to 2 u, a coefficient c_j dt_0^j of the seven halved levels is known to 2 u sum_i |w_ji| (dt_i
// / dt_0)^2p of the largest square, w the weights of the series (statistics/orders/power_series.cpp). That sum is 0.011
// and 1.18 for j = 0 and 1 where p = 1, and 1e-4, 0.012 and 0.46 for j = 0, 1, 2 where p = 2: below 1.2. The series'
// own truncation has no share in it: where that is wider, nothing is concluded.
constexpr double most_gain = 1.2;
double allowed_square(double largest) {
  return std::max(narrow_parameter * narrow_parameter, 2 * most_gain * unseen_share * largest);
}

/// A coefficient of one column, times dt^power at the coarsest dt, in the column's scale.
struct found_term {
  std::string_view column;
  std::size_t power;
  interval_estimate share;
  double allowed;  ///< half-width

  double half() const { return (share.high - share.low) / 2; }
  double far() const { return std::fabs(share.value) / std::max(half(), 1e-300); }  // above one: not zero
  double width() const { return half() / allowed; }
};

/// One column over the levels, in its scale; of the residual, a norm, the square, which has a power series where the
/// norm has none.
struct column_values {
  std::vector<double> value, uncertainty;
  double largest() const { return std::ranges::max(value); }
  column_values(const modified_columns& columns, const error_table& t, Eigen::Index j) {
    for (std::size_t i = 0; i < t.dt.size(); ++i) {
      const double y = t.error[i][j] / columns.scale[j], u = t.uncertainty[i][j] / columns.scale[j];
      const bool square = j == modified_columns::residual;
      value.push_back(square ? y * y : y);
      uncertainty.push_back(square ? (2 * std::fabs(y) + u) * u : u);
    }
  }
};

/// The coefficients that have to vanish: below dt^order, and of the square below dt^(2 order), the first three of them.
std::vector<found_term> terms_of(const modified_columns& columns, const error_table& t, int order) {
  std::vector<found_term> out;
  const double coarsest = std::ranges::max(t.dt);
  for (Eigen::Index j = 0; j < modified_columns::count; ++j) {
    const bool square = j == modified_columns::residual;
    const auto count = static_cast<std::size_t>(square ? std::min(2 * order, 3) : order);
    const column_values c(columns, t, j);
    const auto series = series_by_all_levels(t.dt, c.value, c.uncertainty, count);
    for (std::size_t power = 0; power < count; ++power) {
      const double unit = std::pow(coarsest, static_cast<double>(power));
      const auto& s = series[power];
      out.push_back({square ? "square of the residual" : modified_columns::names()[static_cast<std::size_t>(j)],
                     power,
                     {unit * s.value, unit * s.low, unit * s.high},
                     square ? allowed_square(c.largest()) : narrow_parameter});
    }
  }
  return out;
}

std::string shown_term(const found_term& f) {
  return fmt::format("{} at {}: {:.2e} [{:.1e}, {:.1e}] of its size", f.column,
                     f.power == 0 ? std::string("dt = 0") : fmt::format("order dt^{}", f.power), f.share.value,
                     f.share.low, f.share.high);
}

}  // namespace

report::verdict judge_parameters(const modified_columns& columns, const error_table& t, int order) {
  report::verdict v{.expected = 0.0};
  const auto needed = static_cast<std::size_t>(order + 3);
  if (t.dt.size() < needed) {
    v.reason = fmt::format("the logarithm is found at {} step sizes, and {} are needed", t.dt.size(), needed);
    return v;
  }
  const auto terms = terms_of(columns, t, order);
  const auto worst = *std::ranges::max_element(terms, {}, &found_term::far);
  const auto widest = *std::ranges::max_element(terms, {}, &found_term::width);
  const bool refuted = worst.far() > 1;
  const auto& decisive = refuted ? worst : widest;
  v.estimate = decisive.share.value;
  v.low = decisive.share.low;
  v.high = decisive.share.high;
  if (refuted)
    v.kind = report::verdict_kind::refuted;
  else if (widest.width() <= 1)
    v.kind = report::verdict_kind::holds;
  v.reason = fmt::format("{}; {}", shown_term(decisive),
                         refuted ? "not zero"
                                 : fmt::format("the least certain of {} terms below dt^{}, all of which "
                                               "include zero",
                                               terms.size(), order));
  return v;
}

}  // namespace polhode
