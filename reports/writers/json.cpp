// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/json.hpp"

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "reports/model/plots.hpp"
#include "reports/plots/descriptions.hpp"
#include "reports/writers/json_rows.hpp"
#include "reports/writers/json_values.hpp"
#include "reports/writers/numbers.hpp"

namespace polhode::report {
namespace {

// The JSON of a plot's description. Included by writers only.

json plot_value(const plot_line&);
json plot_value(const plot_alternative&);

template <class Value>
void add_unless_empty(json& out, const char* key, const Value& value) {
  if (value != Value{}) out[key] = value;
}

template <class Row>
void add_list(json& out, const char* key, const std::vector<Row>& rows) {
  for (const auto& row : rows) out[key].push_back(plot_value(row));
}

/// Its experiment is that of the plot.
json series_in_plot(const series_id& s) {
  return {{"scheme", s.scheme}, {"quantity", s.quantity}, {"observable", s.observable}, {"over", s.over}};
}

json plot_value(const plot_line& line) {
  json out{{"series", series_in_plot(line.series)}};
  if (line.across) out["across"] = series_in_plot(*line.across);
  for (const auto& s : line.beside) out["beside"].push_back(series_in_plot(s));
  if (line.border) out["border"] = series_in_plot(*line.border);
  return out;
}

json plot_value(const plot_alternative& other) {
  json out{{"name", other.name}, {"title", other.title}, {"y_title", other.y_title}};
  add_list(out, "lines", other.lines);
  return out;
}

/// What a plot does not have is left out.
json to_value(const plot_description& p) {
  json out{{"id", p.id}, {"experiment", p.experiment}, {"kind", std::string(name_of(p.kind))}, {"title", p.title}};
  add_unless_empty(out, "note", p.note);
  add_unless_empty(out, "of", p.of);
  add_unless_empty(out, "x", p.x);
  add_unless_empty(out, "y", p.y);
  add_unless_empty(out, "conditions", p.conditions);
  add_unless_empty(out, "x_title", p.x_title);
  add_unless_empty(out, "y_title", p.y_title);
  add_unless_empty(out, "value_title", p.value_title);
  add_unless_empty(out, "border_title", p.border_title);
  add_unless_empty(out, "log_x", p.log_x);
  add_unless_empty(out, "log_y", p.log_y);
  add_unless_empty(out, "log_values", p.log_values);
  add_unless_empty(out, "absolute_title", p.absolute_title);
  add_unless_empty(out, "diverging", p.diverging);
  add_unless_empty(out, "border_across", p.border_across);
  add_unless_empty(out, "hollow", p.hollow);
  add_unless_empty(out, "slopes", p.slopes);
  if (p.claimed) out["claimed"] = number(p.claimed);
  add_list(out, "lines", p.lines);
  for (const auto& s : p.levels) out["levels"].push_back(series_in_plot(s));
  add_list(out, "others", p.others);
  return out;
}

template <class Row, class Write>
json list_of(const std::vector<Row>& rows, Write write) {
  json list = json::array();
  for (const auto& row : rows) list.push_back(write(row));
  return list;
}

json to_value(const experiment& e) { return {{"name", e.name}, {"question", e.question}, {"notes", e.notes}}; }

json to_value(const counters& c) {
  return {{"normals_drawn", c.normals_drawn}, {"path_steps", c.path_steps}, {"kernels_run", c.kernels_run}};
}

json to_value(const saved& s) {
  auto out = to_value(s.work);
  out["cpu_seconds"] = number(s.cpu_seconds);
  return out;
}

json to_value(const skip& s) {
  return {{"experiment", s.experiment}, {"scheme", s.scheme}, {"reason", s.reason}, {"saved", to_value(s.saved)}};
}

json to_value(const saving& s) {
  return {{"experiment", s.experiment},
          {"scheme", s.scheme},
          {"what", s.what},
          {"reason", s.reason},
          {"saved", to_value(s.saved)}};
}

json to_value(const reuse& r) {
  return {{"experiment", r.experiment}, {"scheme", r.scheme}, {"computed", r.computed}, {"saved", to_value(r.saved)}};
}

json to_value(const work_done& d) {
  auto out = to_value(d.work);
  out["experiments_run"] = d.experiments_run;
  out["results_computed"] = d.results_computed;
  out["results_reused"] = d.results_reused;
  return out;
}

json to_value(const profile_row& p) {
  return {{"experiment", p.experiment}, {"scheme", p.scheme}, {"cpu_seconds", number(p.cpu_seconds)}};
}

json to_value(const audited_noise& n) {
  const auto deviation = [](const audited_noise::deviation& d) {
    return json{{"what", d.what}, {"standard_errors", number(d.z)}};
  };
  return {{"experiment", n.experiment},
          {"part", n.part},
          {"scheme", n.scheme},
          {"increments", number(n.increments)},
          {"areas", number(n.areas)},
          {"of_increments", list_of(n.of_increments, deviation)},
          {"of_areas", list_of(n.of_areas, deviation)}};
}

json to_value(const density& d) {
  json values = json::array();
  for (const double x : d.values) values.push_back(number(x));
  return {{"experiment", d.experiment}, {"scheme", d.scheme},   {"name", d.name},  {"time", number(d.time)},
          {"longitudes", d.longitudes}, {"heights", d.heights}, {"values", values}};
}

// Lists one record a line: a document that can be searched and compared line by line.
std::string laid_out(const json& document) {
  std::string out = "{";
  for (const auto& [key, value] : document.items()) {
    out += (out.size() == 1 ? "\n" : ",\n") + compact(key) + ":";
    if (!value.is_array() || value.empty()) {
      out += compact(value);
      continue;
    }
    for (std::size_t i = 0; i < value.size(); ++i) out += (i == 0 ? "[\n" : ",\n") + compact(value[i]);
    out += "\n]";
  }
  return out + "\n}\n";
}

}  // namespace

std::string to_json(const results& r) {
  const auto row = [](const auto& value) { return to_value(value); };
  json document;
  document["schema"] = schema_of(schema_name, schema_version);
  document["provenance"] = to_value(r.provenance);
  if (!r.to_come.empty()) document["to_come"] = r.to_come;
  document["scene"] = to_value(r.scene);
  document["schemes"] = list_of(r.schemes, row);
  document["experiments"] = list_of(r.experiments, row);
  document["measurements"] = list_of(r.measurements, row);
  document["fits"] = list_of(r.fits, row);
  document["verdicts"] = list_of(r.verdicts, row);
  document["skipped"] = list_of(r.skipped, row);
  document["savings"] = list_of(r.savings, row);
  document["reused"] = list_of(r.reused, row);
  if (!r.densities.empty()) document["densities"] = list_of(r.densities, row);
  if (!r.audits.empty()) document["audits"] = list_of(r.audits, row);
  document["plots"] = list_of(plots_of(r), row);
  document["counters"] = to_value(r.done);
  if (!r.profile.empty()) document["profile"] = list_of(r.profile, row);
  return laid_out(document);
}

bool looks_like_results(std::string_view beginning) { return begins_with_schema(beginning, schema_name); }

}  // namespace polhode::report
