// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/series.hpp"

#include <algorithm>
#include <cmath>

#include "reports/model/finite.hpp"
#include "reports/model/names.hpp"
#include "reports/plots/descriptions.hpp"
#include "reports/writers/board.hpp"
#include "reports/writers/cost_error.hpp"
#include "reports/writers/text.hpp"

namespace polhode::report {
namespace {

std::vector<plot_point> points_of(const rows_by_series& all, const plot_description& p, const plot_line& line) {
  std::vector<plot_point> points;
  for (const auto* m : all.at(line.series))
    if (const auto x = finite(m->at_coordinate(p.x)), y = finite(m->value); x && y)
      points.push_back({*x, *y, finite(m->low), finite(m->high), m->used});
  return points;
}

std::optional<plot_power> power_of(const std::vector<const fit*>& fits, const series_id& of) {
  for (const auto* f : fits)
    if (std::isfinite(f->order) && f->prefactor > 0 && f->series() == of) return plot_power{f->order, f->prefactor};
  return std::nullopt;
}

plot drawn_plot(const results& r, const rows_by_series& all, const plot_description& p) {
  const auto schemes = scheme_names(r);
  const auto fits = fits_of(r, p.experiment);
  const auto& y_title = p.log_y && !p.absolute_title.empty() ? p.absolute_title : p.y_title;
  plot out{as_written(p.title), as_written(p.x_title), as_written(y_title), p.log_x, p.log_y, {}};
  for (const auto& line : p.lines) {
    const auto& scheme = line.series.scheme;
    plot_series one{scheme.empty() ? "no scheme" : scheme, {}, {}, 0};
    one.points = p.kind == plot_kind::front ? cost_points(all, line) : points_of(all, p, line);
    if (one.points.empty()) continue;
    std::ranges::stable_sort(one.points, {}, &plot_point::x);
    one.fitted = power_of(fits, line.series);
    one.style = static_cast<std::size_t>(std::ranges::find(schemes, scheme) - schemes.begin());
    out.series.push_back(std::move(one));
  }
  return out;
}

}  // namespace

std::vector<series> series_of(const results& r) {
  std::vector<series> all;
  std::map<series_id, std::size_t> known;
  for (const auto& m : r.measurements) {
    const auto [place, is_new] = known.try_emplace(m.series(), all.size());
    if (is_new) all.emplace_back();
    auto& one = all[place->second];
    one.rows.push_back(&m);
    if (!finite(m.value)) {
      ++one.missing;
      continue;
    }
    if (one.first == nullptr) one.first = &m;
    one.last = &m;
  }
  return all;
}

std::vector<plot> drawable_plots(const results& r, const std::string& experiment) {
  rows_by_series all;
  for (const auto& m : r.measurements)
    if (m.experiment == experiment) all[m.series()].push_back(&m);
  std::vector<plot> plots;
  for (const auto& p : plots_of(r, experiment)) {
    if (p.kind != plot_kind::curve && p.kind != plot_kind::front) continue;
    if (auto one = drawn_plot(r, all, p); !one.series.empty()) plots.push_back(std::move(one));
  }
  return plots;
}

}  // namespace polhode::report
