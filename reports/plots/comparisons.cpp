// SPDX-License-Identifier: Apache-2.0
#include "reports/plots/builders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "reports/model/finite.hpp"
#include "reports/plots/titles.hpp"

namespace polhode::report {
namespace {

/// What all of them are held against, if it is one number.
std::optional<double> claimed_by_all(const findings& found, const row_list& rows) {
  std::set<std::optional<double>> claimed;
  for (const auto* m : rows)
    if (finite(m->value)) claimed.insert(claimed_of(found, m->series()));
  return claimed.size() == 1 ? *claimed.begin() : std::nullopt;
}

/// The step size, where it is the same for all.
std::string common_step(const row_list& rows) {
  const auto dt = rows.front()->dt();
  const bool common = dt && std::ranges::all_of(rows, [&](const measurement* m) { return m->dt() == dt; });
  return common ? fmt::format(" at {} = {:.4g}", step_size, *dt) : "";
}

/// Values, and the lower ends of their intervals.
std::vector<double> reaching(const row_list& rows) {
  auto values = values_of(rows);
  for (const auto* m : rows)
    if (finite(m->value) && finite(m->low)) values.push_back(*m->low);
  return values;
}

bool says_something(const measurement& m) { return finite(m.value) || finite(m.low) || finite(m.high); }

plot_description matrix_of(const findings& found, const row_list& rows) {
  const auto& first = *rows.front();
  return {.id = slug({found.experiment, first.quantity}),
          .experiment = found.experiment,
          .kind = plot_kind::matrix,
          .title = with_unit(first.quantity, first.unit),
          .note = "≥: nothing that was tried lies beyond. <: smaller than all that was tried.",
          .conditions = conditions_of(rows),
          .value_title = with_unit(first.quantity, first.unit),
          .log_values = spans(values_of(rows), wide_for_steps),
          .lines = lines_of(found, rows)};
}

}  // namespace

plot_description comparison_of(const findings& found, const row_list& rows) {
  const auto& first = *rows.front();
  return {.id = slug({found.experiment, first.quantity, first.observable}),
          .experiment = found.experiment,
          .kind = plot_kind::comparison,
          .title = title_of(first) + common_step(rows),
          .note = missing_in(rows),
          .x_title = title_of(first),
          .log_x = spans(reaching(rows), wide),
          .claimed = claimed_by_all(found, rows),
          .lines = lines_of(found, rows)};
}

std::vector<plot_description> standing_values(findings& found) {
  const auto own = rows_where(found.rows, [](const measurement& m) { return !m.scheme.empty() && !abscissa_of(m); });
  std::vector<plot_description> plots;
  for (const auto& rows : grouped(own, [](const measurement& m) { return m.quantity; })) {
    if (std::ranges::none_of(rows, [](const measurement* m) { return says_something(*m); })) continue;
    const auto conditions = grouped(rows, condition_of);
    plots.push_back(conditions.size() > 1 ? matrix_of(found, rows) : comparison_of(found, rows));
    take(found, rows);
  }
  return plots;
}

}  // namespace polhode::report
