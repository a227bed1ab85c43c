// What an accuracy costs, as a table.
#include "reports/writers/cost_error.hpp"
#include "reports/writers/html_parts.hpp"
#include "reports/writers/numbers.hpp"
#include "reports/writers/places.hpp"
#include "reports/writers/text.hpp"

namespace polhode::report::html {

void put_cost_table(std::string& out, const results& r, const std::string& experiment) {
  const auto lines = cost_table_of(r, experiment);
  if (lines.empty()) return;
  put(out,
      "<h3>To reach an accuracy</h3>\n<p class=\"note\">Cost: {}.</p>\n<div class=\"wide\">\n<table "
      "class=\"list\">\n<thead><tr><th>error</th><th>cheapest</th><th class=\"n\">dt</th><th "
      "class=\"n\">cost</th><th>range</th><th class=\"n\">ratio to the "
      "next</th><th>range</th><th>which</th></tr></thead>\n<tbody>\n",
      escape_html(lines.front().cost->unit));
  for (const auto& [what, cost, next] : lines)
    put(out,
        "<tr><th scope=\"row\">{}</th><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td "
        "class=\"i\">{}</td><td class=\"n\">{}</td><td class=\"i\">{}</td><td>{}</td></tr>\n",
        escape_html(as_written(what)), escape_html(cost->scheme), shown(cost->dt), shown(cost->value),
        shown_interval(cost->low, cost->high), next ? shown(next->value) : "–",
        next ? shown_interval(next->low, next->high) : "–",
        next ? escape_html(next->status) : "no other measured scheme reaches it");
  out += "</tbody>\n</table>\n</div>\n";
}

}  // namespace polhode::report::html
