#include "reports/writers/field.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "reports/writers/board.hpp"
#include "reports/writers/numbers.hpp"

namespace polhode::report {
namespace {

bool drawable(double x) { return std::isfinite(x) && x > 0; }

bool is_cell(const measurement& m, const std::string& experiment) {
  return m.experiment == experiment && in_field(m) && drawable(*m.dt) && finite(m.value) &&
         drawable(coordinate_of(m.observable)->value);
}

void add_border(heat_map& map, const measurement& m, const coordinate& at) {
  map.border.push_back({at.value, finite(m.low), finite(m.high), status_of(m)});
}

heat_map map_of(const results& r, const std::string& experiment, const std::string& scheme,
                const std::string& quantity) {
  heat_map map;
  map.title = scheme;
  map.x_title = "dt";
  std::vector<std::string> seen;
  for (const auto& m : r.measurements) {
    if (m.scheme != scheme || m.quantity != quantity || !is_cell(m, experiment)) continue;
    const auto at = *coordinate_of(m.observable);
    map.y_title = at.name;
    map.cells.push_back({*m.dt, at.value, *m.value, m.status == "ok" ? "" : m.status});
    if (std::ranges::find(seen, m.observable) == seen.end()) seen.push_back(m.observable);
  }
  for (const auto& m : r.measurements)
    if (m.experiment == experiment && m.scheme == scheme && !m.dt && m.unit == "time" &&
        std::ranges::find(seen, m.observable) != seen.end())
      add_border(map, m, *coordinate_of(m.observable));
  std::ranges::sort(map.border, {}, &border_point::y);
  return map;
}

/// So that maps beside each other can be compared.
void share_axes(std::vector<heat_map>& maps, std::size_t first) {
  std::vector<double> x, y;
  for (auto i = first; i < maps.size(); ++i)
    for (const auto& cell : maps[i].cells) {
      x.push_back(cell.x);
      y.push_back(cell.y);
    }
  for (auto* values : {&x, &y}) {
    std::ranges::sort(*values);
    const auto same = std::ranges::unique(*values);
    values->erase(same.begin(), same.end());
  }
  for (auto i = first; i < maps.size(); ++i) {
    maps[i].columns = x;
    maps[i].rows = y;
  }
}

}  // namespace

std::optional<coordinate> coordinate_of(std::string_view observable) {
  const auto equals = observable.find('=');
  if (equals == std::string_view::npos || equals == 0) return std::nullopt;
  const auto text = observable.substr(equals + 1);
  coordinate out{std::string(observable.substr(0, equals)), 0};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out.value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return out;
}

bool in_field(const measurement& m) { return m.dt.has_value() && coordinate_of(m.observable).has_value(); }

std::vector<heat_map> maps_of(const results& r, const std::string& experiment) {
  std::vector<std::string> quantities;
  for (const auto& m : r.measurements)
    if (is_cell(m, experiment) && std::ranges::find(quantities, m.quantity) == quantities.end())
      quantities.push_back(m.quantity);
  std::vector<heat_map> maps;
  for (const auto& quantity : quantities) {
    const auto first = maps.size();
    for (const auto& scheme : scheme_names(r))
      if (auto map = map_of(r, experiment, scheme, quantity); !map.cells.empty()) maps.push_back(std::move(map));
    share_axes(maps, first);
  }
  return maps;
}

}  // namespace polhode::report
