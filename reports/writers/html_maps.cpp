// What the schemes do over two parameters: maps with their border, and tables of what belongs to no step size.
#include <algorithm>

#include "reports/writers/field.hpp"
#include "reports/writers/html_parts.hpp"
#include "reports/writers/numbers.hpp"
#include "reports/writers/text.hpp"

namespace polhode::report::html {
namespace {

/// A number of a scheme that belongs to no step size, but has an interval: a border, say.
bool in_table(const measurement& m, const std::string& experiment) {
  return m.experiment == experiment && !m.scheme.empty() && !m.dt && !m.steps && (m.low || m.high);
}

void add_once(std::vector<std::string>& names, const std::string& name) {
  if (std::ranges::find(names, name) == names.end()) names.push_back(name);
}

/// The value, or the end that is known; below it what the status says after its colon.
std::string cell_of(const measurement& m) {
  const auto status = status_of(m);
  const auto colon = status.rfind(": ");
  const auto number = m.value && !m.high ? "≥ " + shown(m.value) : m.value ? shown(m.value) : "< " + shown(m.high);
  return fmt::format("<td>{}<br><small>{}</small></td>", number,
                     escape_html(status == "ok"               ? ""
                                 : colon == std::string::npos ? ""
                                                              : status.substr(colon + 2)));
}

void put_table(std::string& out, const results& r, const std::string& experiment, const std::string& quantity) {
  std::vector<std::string> columns;
  for (const auto& m : r.measurements)
    if (in_table(m, experiment) && m.quantity == quantity) add_once(columns, m.observable);
  put(out, "<h3>{}</h3>\n<div class=\"wide\">\n<table class=\"cross\">\n<thead><tr><th>scheme</th>",
      escape_html(quantity));
  for (const auto& column : columns) put(out, "<th>{}</th>", escape_html(column));
  out += "</tr></thead>\n<tbody>\n";
  for (const auto& scheme : scheme_names(r)) {
    std::string row;
    for (const auto& m : r.measurements)
      if (in_table(m, experiment) && m.quantity == quantity && m.scheme == scheme) row += cell_of(m);
    if (!row.empty()) put(out, "<tr><th scope=\"row\">{}</th>{}</tr>\n", escape_html(scheme), row);
  }
  out += "</tbody>\n</table>\n</div>\n";
}

}  // namespace

void put_maps(std::string& out, const results& r, const std::string& experiment) {
  const auto maps = maps_of(r, experiment);
  if (maps.empty()) return;
  out +=
      "<h3>Maps</h3>\n<p class=\"key\">The lighter a cell, the larger the share; ×: crossed for the reason that its "
      "title gives; empty: not tried. Line: the border by bisection; ▶ nothing tried lies beyond it, ◀ everything "
      "does.</p>\n<div class=\"maps\">\n";
  for (const auto& map : maps)
    put(out, "<figure>\n<figcaption>{}</figcaption>\n{}</figure>\n", escape_html(map.title), to_svg(map));
  out += "</div>\n";
}

void put_tables(std::string& out, const results& r, const std::string& experiment) {
  std::vector<std::string> quantities;
  for (const auto& m : r.measurements)
    if (in_table(m, experiment)) add_once(quantities, m.quantity);
  for (const auto& quantity : quantities) put_table(out, r, experiment, quantity);
}

}  // namespace polhode::report::html
