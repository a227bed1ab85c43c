// SPDX-License-Identifier: Apache-2.0
#include "reports/plots/builders.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <tuple>

#include "reports/model/finite.hpp"
#include "reports/plots/titles.hpp"

namespace polhode::report {
namespace {

/// Every scheme at one abscissa: nothing that a curve could show.
bool one_each(const row_list& rows) {
  std::set<std::string> schemes;
  for (const auto* m : rows) schemes.insert(m->scheme);
  return schemes.size() > 1 && schemes.size() == rows.size();
}

/// Numbers of the same quantity without an abscissa.
row_list levels_of(const findings& found, const measurement& of) {
  return rows_where(found.rows, [&](const measurement& m) {
    return m.over.empty() && m.quantity == of.quantity && m.observable == of.observable && place_of(m).empty() &&
           finite(m.value);
  });
}

std::string abscissa_title(const std::string& over) {
  return over == step_size ? "step size dt" : over == step_count ? "number of steps" : over;
}

/// Claimed orders of the fitted lines, at most four.
std::vector<double> slopes_of(const findings& found, const std::vector<plot_line>& lines) {
  std::set<double> slopes;
  for (const auto& line : lines)
    if (fit_of(found, line.series))
      if (const auto claimed = claimed_of(found, line.series); claimed && *claimed != 0 && slopes.size() < 4)
        slopes.insert(*claimed);
  return {slopes.begin(), slopes.end()};
}

/// Logarithmic where a power law was fitted, or where the values span more than a linear axis can show. What decays in
/// time decays exponentially: straight over a linear abscissa.
void choose_axes(plot_description& p, const findings& found, const row_list& rows) {
  const bool fitted =
      std::ranges::any_of(p.lines, [&](const plot_line& line) { return fit_of(found, line.series) != nullptr; });
  p.log_y = fitted || spans(values_of(rows), wide);
  std::vector<double> abscissas;
  for (const auto* m : rows)
    if (const auto x = abscissa_of(*m)) abscissas.push_back(*x);
  const bool decay = p.x.starts_with("time") && !fitted;
  p.log_x = !decay && spans(abscissas, wide_for_steps) && (p.log_y || p.x != step_size || !fitted);
}

plot_description curve_of(const findings& found, const row_list& rows, const row_list& levels) {
  const auto& first = *rows.front();
  plot_description p{.id = slug({found.experiment, first.quantity, first.observable}),
                     .experiment = found.experiment,
                     .kind = plot_kind::curve,
                     .title = title_of(first),
                     .note = missing_in(rows),
                     .x = first.over,
                     .x_title = abscissa_title(first.over),
                     .y_title = title_of(first),
                     .lines = lines_of(found, rows)};
  choose_axes(p, found, rows);
  if (std::ranges::any_of(values_of(rows), [](double y) { return y < 0; })) p.absolute_title = absolute_title_of(first);
  if (std::ranges::any_of(rows, &measurement::used)) p.hollow = "dropped by the rule of the fit";
  p.slopes = slopes_of(found, p.lines);
  for (const auto& line : lines_of(found, levels)) p.levels.push_back(line.series);
  return p;
}

}  // namespace

std::vector<plot_description> curve_plots(findings& found) {
  auto curves = grouped(rows_where(found.rows, [](const measurement& m) { return abscissa_of(m).has_value(); }),
                        [](const measurement& m) { return std::tuple(m.quantity, m.observable, m.over); });
  std::ranges::stable_partition(curves, [](const row_list& rows) { return !rows.front()->scheme.empty(); });
  std::vector<plot_description> plots;
  row_list levels;
  for (const auto& rows : curves) {
    if (one_each(rows)) {
      plots.push_back(comparison_of(found, rows));
    } else {
      const auto own = levels_of(found, *rows.front());
      plots.push_back(curve_of(found, rows, own));
      levels.insert(levels.end(), own.begin(), own.end());
    }
    take(found, rows);
  }
  take(found, levels);
  return plots;
}

}  // namespace polhode::report
