// SPDX-License-Identifier: Apache-2.0
#include "experiments/modified/modified_report.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/common/judge.hpp"

namespace polhode {
namespace {

constexpr double nothing_left = 1e-11;  // a residual that is rounding

/// A parameter's group, columns first ... first + count - 1 of the table, and how it is reported.
struct group {
  const char *name, *quantity, *unit;
  Eigen::Index first, count;
};
constexpr group groups[] = {{"inverse inertia", "effective inverse inertia", "1/I", 0, 3},
                            {"dissipation", "effective dissipation", "theta/I", 3, 3},
                            {"noise", "effective noise", "sigma^2", 6, 6}};

std::string name_of(Eigen::Index column) {
  return std::string(modified_columns::names()[static_cast<std::size_t>(column)]);
}

/// Off the diagonal of Q there is something to see where the scene has it, or the scheme makes it.
bool is_shown(const modified_columns& columns, const error_table& t, Eigen::Index column) {
  if (column != 7 && column != 8 && column != 10) return true;
  bool seen = columns.exact[column] != 0;
  for (std::size_t i = 0; i < t.dt.size(); ++i)
    seen = seen || std::fabs(t.error[i][column]) > 10 * t.uncertainty[i][column] + 1e-9 * columns.unit[column];
  return seen;
}

report::series_id report_parameter(const group& g, const modified_columns& columns, Eigen::Index column,
                                   const error_table& t, recorder& record) {
  curve parameter{{g.quantity, name_of(column), g.unit, "transfer"}};
  for (std::size_t i = 0; i < t.dt.size(); ++i) {
    const double value = columns.exact[column] + t.error[i][column], u = t.uncertainty[i][column];
    parameter.add(t.dt[i], value, value - u, value + u);
  }
  return record.series(parameter);
}

/// A norm and its uncertainty over dt, with the order at which it falls.
class norm_over_dt {
 public:
  explicit norm_over_dt(quantity what) : curve_{std::move(what)} {}
  void add(double dt, double norm, double u) {
    curve_.add(dt, norm, std::max(0.0, norm - u), norm + u);
    dt_.push_back(dt);
    resolved_.push_back(norm > 50 * u ? norm : std::numeric_limits<double>::quiet_NaN());
    largest_ = std::max(largest_, norm - u);
  }
  std::optional<order_fit> fit() const { return fit_order(dt_, resolved_, 0); }
  const curve& points() const { return curve_; }
  double largest() const { return largest_; }  ///< surely

 private:
  curve curve_;
  std::vector<double> dt_, resolved_;
  double largest_ = 0;
};

/// |p - p_scene| of a group.
report::series_id report_distance(const group& g, const error_table& t, recorder& record) {
  norm_over_dt distance({"error", g.name, g.unit, "transfer"});
  for (std::size_t i = 0; i < t.dt.size(); ++i)
    distance.add(t.dt[i], t.error[i].segment(g.first, g.count).norm(),
                 t.uncertainty[i].segment(g.first, g.count).norm());
  return record.series(distance.points(), distance.fit());
}

report::series_id report_residual(int order, const error_table& t, recorder& record) {
  norm_over_dt residual({"residual", "", "", "transfer"});
  for (std::size_t i = 0; i < t.dt.size(); ++i)
    residual.add(t.dt[i], t.error[i][modified_columns::residual], t.uncertainty[i][modified_columns::residual]);
  const auto fit = residual.fit();
  const auto written = record.series(residual.points(), fit);
  auto v = judge_order(order, fit, true);
  if (!fit && t.dt.size() >= 4 && residual.largest() < nothing_left) {
    v.kind = report::verdict_kind::holds;
    v.reason = "no residual: at every dt the scheme solves the equation of a rigid body";
  }
  record.verdict("residual falls at the weak order", std::move(v), {written});
  return written;
}

}  // namespace

std::vector<report::series_id> report_modified_equation(const modified_columns& columns, int order,
                                                        const error_table& t, recorder& record) {
  std::vector evidence{report_residual(order, t, record)};
  for (const auto& g : groups) evidence.push_back(report_distance(g, t, record));
  for (const auto& g : groups)
    for (Eigen::Index j = g.first; j < g.first + g.count; ++j)
      if (is_shown(columns, t, j)) evidence.push_back(report_parameter(g, columns, j, t, record));
  return evidence;
}

void report_own_parameters(const modified_columns& columns, recorder& record) {
  for (const auto& g : groups)
    for (Eigen::Index j = g.first; j < g.first + g.count; ++j)
      if (columns.exact[j] != 0 || j < 6 || j == 6 || j == 9 || j == 11)
        record.value({g.quantity, name_of(j), g.unit, "scene"}, columns.exact[j]);
}

}  // namespace polhode
