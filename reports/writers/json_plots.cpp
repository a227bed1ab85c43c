// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/json_plots.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace polhode::report {
namespace {

json to_value(const plot_line&);
json to_value(const plot_alternative&);

template <class Value>
void add(json& out, const char* key, const Value& value) {
  if (value != Value{}) out[key] = value;
}

template <class Row>
void add_list(json& out, const char* key, const std::vector<Row>& rows) {
  for (const auto& row : rows) out[key].push_back(to_value(row));
}

/// Its experiment is that of the plot.
json series_value(const series_id& s) {
  return {{"scheme", s.scheme}, {"quantity", s.quantity}, {"observable", s.observable}, {"over", s.over}};
}

json to_value(const plot_line& line) {
  json out{{"series", series_value(line.series)}};
  if (line.across) out["across"] = series_value(*line.across);
  for (const auto& s : line.beside) out["beside"].push_back(series_value(s));
  if (line.border) out["border"] = series_value(*line.border);
  return out;
}

json to_value(const plot_alternative& other) {
  json out{{"name", other.name}, {"title", other.title}, {"y_title", other.y_title}};
  add_list(out, "lines", other.lines);
  return out;
}

}  // namespace

json to_value(const plot_description& p) {
  json out{{"id", p.id}, {"experiment", p.experiment}, {"kind", std::string(name_of(p.kind))}, {"title", p.title}};
  add(out, "note", p.note);
  add(out, "of", p.of);
  add(out, "x", p.x);
  add(out, "y", p.y);
  add(out, "conditions", p.conditions);
  add(out, "x_title", p.x_title);
  add(out, "y_title", p.y_title);
  add(out, "value_title", p.value_title);
  add(out, "border_title", p.border_title);
  add(out, "log_x", p.log_x);
  add(out, "log_y", p.log_y);
  add(out, "log_values", p.log_values);
  add(out, "absolute_title", p.absolute_title);
  add(out, "diverging", p.diverging);
  add(out, "border_across", p.border_across);
  add(out, "hollow", p.hollow);
  add(out, "slopes", p.slopes);
  if (p.claimed) out["claimed"] = number(p.claimed);
  add_list(out, "lines", p.lines);
  for (const auto& s : p.levels) out["levels"].push_back(series_value(s));
  add_list(out, "others", p.others);
  return out;
}

}  // namespace polhode::report
