#include "reports/writers/series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "reports/writers/board.hpp"
#include "reports/writers/cost_error.hpp"
#include "reports/writers/field.hpp"
#include "reports/writers/numbers.hpp"

namespace polhode::report {
namespace {

struct chart {
  std::string quantity, observable, unit, abscissa;
  bool over_steps = false;
  std::vector<const measurement*> rows;  // with an abscissa and a value
};

bool has_value(const measurement& m) { return finite(m.value).has_value(); }
std::optional<double> abscissa(const measurement& m) { return finite(m.steps) ? m.steps : finite(m.dt); }

std::vector<chart> charts_of(const results& r, const std::string& experiment) {
  std::vector<chart> charts;
  std::map<std::tuple<std::string, std::string, bool>, std::size_t> known;
  for (const auto& m : r.measurements) {
    if (m.experiment != experiment || !has_value(m) || !abscissa(m) || in_field(m) || says_cost(m)) continue;
    const bool over_steps = finite(m.steps).has_value();
    const auto [place, is_new] = known.try_emplace({m.quantity, m.observable, over_steps}, charts.size());
    if (is_new) charts.push_back({m.quantity, m.observable, m.unit, m.abscissa, over_steps, {}});
    charts[place->second].rows.push_back(&m);
  }
  return charts;
}

const fit* fit_of(const std::vector<const fit*>& fits, const chart& c, const std::string& scheme) {
  const auto found = std::find_if(fits.begin(), fits.end(), [&](const fit* f) {
    return f->scheme == scheme && f->quantity == c.quantity && f->observable == c.observable;
  });
  return found == fits.end() ? nullptr : *found;
}

plot_series drawn(const chart& c, const std::string& scheme) {
  plot_series one;
  one.name = scheme.empty() ? "no scheme" : scheme;
  for (const auto* m : c.rows)
    if (m->scheme == scheme)
      one.points.push_back({*abscissa(*m), *m->value, finite(m->low), finite(m->high), m->fitted});
  std::sort(one.points.begin(), one.points.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  return one;
}

// Logarithmic where a power law was fitted, or where positive values span more than a linear axis can show.
bool wants_log(const chart& c, bool has_fit) {
  if (has_fit) return true;
  const auto [least, most] = std::minmax_element(c.rows.begin(), c.rows.end(),
                                                 [](const auto* a, const auto* b) { return *a->value < *b->value; });
  return *(*least)->value > 0 && *(*most)->value > 30 * *(*least)->value;
}

bool wants_log_abscissa(const chart& c) {
  const auto [least, most] = std::minmax_element(
      c.rows.begin(), c.rows.end(), [](const auto* a, const auto* b) { return *abscissa(*a) < *abscissa(*b); });
  return *abscissa(**least) > 0 && *abscissa(**most) >= 3 * *abscissa(**least);
}

std::string ordinate_title(const chart& c, bool absolute) {
  std::string title = absolute ? fmt::format("|{}|", c.quantity) : c.quantity;
  if (!c.observable.empty()) title += fmt::format(" of {}", c.observable);
  if (!c.unit.empty() && c.unit != "1") title += fmt::format(" [{}]", c.unit);
  return title;
}

plot plot_of(const chart& c, const std::vector<const fit*>& fits, const std::vector<std::string>& schemes) {
  plot p;
  bool has_fit = false;
  for (std::size_t i = 0; i < schemes.size(); ++i) {
    auto one = drawn(c, schemes[i]);
    if (one.points.empty()) continue;
    one.style = i;
    if (const auto* f = fit_of(fits, c, schemes[i]); f != nullptr && std::isfinite(f->order) && f->prefactor > 0) {
      has_fit = true;
      one.fitted = plot_power{f->order, f->prefactor};
    }
    p.series.push_back(std::move(one));
  }
  p.log_y = wants_log(c, has_fit);
  const bool decay = c.abscissa.starts_with("time") && !has_fit;  // exponential: straight over a linear axis
  p.log_x = !decay && wants_log_abscissa(c) && (p.log_y || c.over_steps || !has_fit);
  const bool signs = std::any_of(c.rows.begin(), c.rows.end(), [](const auto* m) { return *m->value < 0; });
  p.x_title = !c.abscissa.empty() ? c.abscissa : c.over_steps ? "number of steps" : "step size dt";
  p.y_title = ordinate_title(c, p.log_y && signs);
  p.title = fmt::format("{} over {}", p.y_title, p.x_title);
  return p;
}

}  // namespace

std::vector<series> series_of(const results& r) {
  std::vector<series> all;
  std::map<std::tuple<std::string, std::string, std::string, std::string>, std::size_t> known;
  for (const auto& m : r.measurements) {
    const auto [place, is_new] = known.try_emplace({m.experiment, m.scheme, m.quantity, m.observable}, all.size());
    if (is_new) all.emplace_back();
    auto& one = all[place->second];
    one.rows.push_back(&m);
    if (!has_value(m)) {
      ++one.missing;
      continue;
    }
    if (one.first == nullptr) one.first = &m;
    one.last = &m;
  }
  return all;
}

std::vector<plot> plots_of(const results& r, const std::string& experiment) {
  const auto fits = fits_of(r, experiment);
  auto schemes = scheme_names(r);
  schemes.emplace_back();  // measurements that belong to no scheme
  std::vector<plot> plots;
  for (const auto& one : charts_of(r, experiment)) plots.push_back(plot_of(one, fits, schemes));
  return plots;
}

}  // namespace polhode::report
