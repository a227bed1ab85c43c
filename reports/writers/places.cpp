#include "reports/writers/places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include "reports/writers/numbers.hpp"

namespace polhode::report {
namespace {

struct coordinate {
  std::string name;
  double value = 0;
};

std::optional<coordinate> read_coordinate(std::string_view word) {
  const auto equals = word.find('=');
  if (equals == 0 || equals == word.npos) return std::nullopt;
  coordinate c{std::string(word.substr(0, equals)), 0};
  const auto number = word.substr(equals + 1);
  const auto [end, fault] = std::from_chars(number.data(), number.data() + number.size(), c.value);
  if (fault != std::errc{} || end != number.data() + number.size()) return std::nullopt;
  return finite(c.value) ? std::optional(c) : std::nullopt;
}

/// Empty where the text is no place.
std::vector<coordinate> read_place(std::string_view text) {
  std::vector<coordinate> place;
  while (true) {
    const auto space = text.find(' ');
    const auto one = read_coordinate(text.substr(0, space));
    if (!one) return {};
    place.push_back(*one);
    if (space == text.npos) return place;
    text.remove_prefix(space + 1);
  }
}

bool has_abscissa(const measurement& m) { return m.dt || m.steps; }

struct group {
  const measurement* first;
  std::vector<std::string> names;  // of the coordinates
  std::vector<std::pair<std::vector<coordinate>, const measurement*>> rows;
};

std::vector<group> groups_of(const results& r, const std::string& experiment, std::size_t coordinates) {
  std::vector<group> groups;
  for (const auto& m : r.measurements) {
    if (m.experiment != experiment || !m.scheme.empty() || has_abscissa(m)) continue;
    if (m.value && !m.low && !m.high) continue;  // a setting, not a result
    auto place = read_place(m.observable);
    if (place.size() != coordinates) continue;
    std::vector<std::string> names;
    for (const auto& c : place) names.push_back(c.name);
    auto known = std::find_if(groups.begin(), groups.end(),
                              [&](const group& g) { return g.first->quantity == m.quantity && g.names == names; });
    if (known == groups.end()) known = groups.insert(known, group{&m, names, {}});
    known->rows.emplace_back(std::move(place), &m);
  }
  return groups;
}

// As for step sizes: logarithmic where a factor of three is spanned.
template <class Value>
bool wants_log(const group& g, const Value& value) {
  const auto [least, most] = std::minmax_element(g.rows.begin(), g.rows.end(),
                                                 [&](const auto& a, const auto& b) { return value(a) < value(b); });
  return value(*least) > 0 && value(*most) >= 3 * value(*least);
}

std::vector<plot_point> points_of(const group& g) {
  std::vector<plot_point> points;
  for (const auto& [place, m] : g.rows)
    if (finite(m->value)) points.push_back({place[0].value, *m->value, finite(m->low), finite(m->high), false});
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  return points;
}

}  // namespace

std::string as_written(std::string text) {
  constexpr std::pair<std::string_view, std::string_view> letters[] = {
      {"lambda_1", "λ₁"}, {"lambda_2", "λ₂"}, {"sigma", "σ"}, {"theta", "θ"}};
  for (const auto& [name, letter] : letters)
    for (auto at = text.find(name); at != text.npos; at = text.find(name, at + letter.size()))
      text.replace(at, name.size(), letter);
  std::ranges::replace(text, '_', ' ');
  return text;
}

std::vector<plot> place_curves_of(const results& r, const std::string& experiment) {
  std::vector<plot> plots;
  for (const auto& g : groups_of(r, experiment, 1)) {
    auto points = points_of(g);
    if (points.empty()) continue;
    plot p;
    p.x_title = as_written(g.names[0]);
    p.y_title = as_written(g.first->unit);
    p.title = fmt::format("{}: {} over {}", as_written(g.first->quantity), p.y_title, p.x_title);
    p.log_x = wants_log(g, [](const auto& row) { return row.first[0].value; });
    p.log_y = false;
    p.series.push_back({as_written(g.first->quantity), std::move(points), {}, 0});
    plots.push_back(std::move(p));
  }
  return plots;
}

std::vector<value_map> place_maps_of(const results& r, const std::string& experiment) {
  std::vector<value_map> maps;
  const auto curves = groups_of(r, experiment, 1);
  for (const auto& g : groups_of(r, experiment, 2)) {
    value_map map;
    map.x_title = as_written(g.names[0]);
    map.y_title = as_written(g.names[1]);
    map.value_title = as_written(g.first->quantity);
    map.title = fmt::format("{} over {} and {}", map.value_title, map.x_title, map.y_title);
    map.log_x = wants_log(g, [](const auto& row) { return row.first[0].value; });
    map.log_y = wants_log(g, [](const auto& row) { return row.first[1].value; });
    for (const auto& [place, m] : g.rows)
      map.cells.push_back({place[0].value, place[1].value, finite(m->value), status_of(*m)});
    for (const auto& c : curves)
      if (c.names[0] == g.names[0] && c.first->unit == g.names[1])
        map.curves.push_back({as_written(c.first->quantity), points_of(c)});
    maps.push_back(std::move(map));
  }
  return maps;
}

std::vector<const measurement*> facts_of(const results& r, const std::string& experiment) {
  std::vector<const measurement*> facts;
  for (const auto& m : r.measurements)
    if (m.experiment == experiment && m.scheme.empty() && m.observable.empty() && !has_abscissa(m)) facts.push_back(&m);
  return facts;
}

}  // namespace polhode::report
