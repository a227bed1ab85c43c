// One experiment: what it asks, its plots, its fits, its verdicts, and what was measured.
#include <algorithm>
#include <iterator>

#include "reports/writers/cost_error.hpp"
#include "reports/writers/html_parts.hpp"
#include "reports/writers/numbers.hpp"
#include "reports/writers/places.hpp"
#include "reports/writers/series.hpp"
#include "reports/writers/text.hpp"

namespace polhode::report::html {
namespace {

constexpr std::size_t most_claims = 8;   // columns that a board can carry
constexpr std::size_t most_rows = 2000;  // measurements that a page should carry

std::string joined(const std::string& left, const std::string& right) {
  return left.empty() || right.empty() ? left + right : left + " of " + right;
}

void put_question(std::string& out, const experiment* declared) {
  if (declared == nullptr) return;
  if (!declared->question.empty()) put(out, "<p class=\"question\">{}</p>\n", escape_html(declared->question));
  if (declared->notes.empty()) return;
  out += "<ul class=\"notes\">\n";
  for (const auto& note : declared->notes) put(out, "<li>{}</li>\n", escape_html(note));
  out += "</ul>\n";
}

// Schemes × claims; pointless where there are no claims, and unreadable where there are too many.
void put_claims(std::string& out, const results& r, const std::vector<const verdict*>& rows) {
  const auto claims = claims_of(rows);
  out += "<div class=\"wide\">\n<table class=\"board\">\n<thead><tr><th scope=\"col\">scheme</th>";
  for (const auto& claim : claims) put(out, "<th scope=\"col\">{}</th>", escape_html(claim));
  out += "</tr></thead>\n<tbody>\n";
  for (const auto& scheme : scheme_names(r)) {
    if (std::none_of(rows.begin(), rows.end(), [&](const auto* v) { return v->scheme == scheme; })) continue;
    put(out, "<tr><th scope=\"row\">{}</th>", escape_html(scheme));
    for (const auto& claim : claims) {
      std::string cell;
      for (const auto* v : rows)
        if (v->scheme == scheme && v->claim == claim) cell += chip(v->kind);
      out += cell.empty() ? "<td class=\"none\">·</td>" : "<td>" + cell + "</td>";
    }
    out += "</tr>\n";
  }
  out += "</tbody>\n</table>\n</div>\n";
}

void put_figure(std::string& out, const std::string& title, const std::string& picture) {
  put(out, "<figure>\n<figcaption>{}</figcaption>\n{}</figure>\n", escape_html(title), picture);
}

// What is known of the scene itself, without a scheme.
void put_facts(std::string& out, const results& r, const std::string& name) {
  const auto facts = facts_of(r, name);
  if (facts.empty()) return;
  out += "<dl class=\"facts\">\n";
  for (const auto* m : facts) {
    std::string value = status_of(*m) == "ok" ? "" : status_of(*m);
    if (finite(m->value)) value = shown_certain(*m) + (value.empty() ? "" : "; " + value);
    put(out, "<div><dt>{}</dt><dd>{}</dd></div>\n", escape_html(as_written(m->quantity)), escape_html(value));
  }
  out += "</dl>\n";
}

// A single plot shares its line with the board, where the page is wide enough for both.
void put_plots_and_claims(std::string& out, const results& r, const std::string& name,
                          const std::vector<const verdict*>& rows) {
  auto plots = plots_of(r, name);
  std::ranges::move(place_curves_of(r, name), std::back_inserter(plots));
  std::ranges::move(cost_plots_of(r, name), std::back_inserter(plots));
  const auto maps = place_maps_of(r, name);
  const auto claims = claims_of(rows).size();
  const bool beside = plots.size() + maps.size() == 1 && claims > 0 && claims <= 3;
  if (!plots.empty() || !maps.empty()) out += "<div class=\"plots\">\n";
  for (const auto& one : plots) put_figure(out, one.title, to_svg(one, svg_use::inside_html));
  for (const auto& one : maps) put_figure(out, one.title, to_svg(one, svg_use::inside_html));
  if (beside) put_claims(out, r, rows);
  if (!plots.empty() || !maps.empty()) out += "</div>\n";
  if (!beside && claims > 1 && claims <= most_claims) put_claims(out, r, rows);
}

void put_verdicts(std::string& out, const std::vector<const verdict*>& rows) {
  if (rows.empty()) return;
  out +=
      "<h3>Verdicts</h3>\n<div class=\"wide\">\n<table class=\"list\">\n<thead><tr><th>scheme</th><th>claim</th><th "
      "class=\"n\">claimed</th>"
      "<th class=\"n\">found</th><th>interval</th><th>verdict</th><th>why</th></tr></thead>\n<tbody>\n";
  for (const auto* v : rows)
    put(out,
        "<tr data-verdict=\"{}\"><th scope=\"row\">{}</th><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td "
        "class=\"i\">{}</td><td>{}</td><td class=\"why\">{}</td></tr>\n",
        name_of(v->kind), escape_html(v->scheme), escape_html(v->claim), shown(v->expected), shown(v->estimate),
        shown_interval(v->low, v->high), chip(v->kind), escape_html(reason_of(*v)));
  out += "</tbody>\n</table>\n</div>\n";
}

void put_fits(std::string& out, const results& r, const std::string& name) {
  const auto fits = fits_of(r, name);
  if (fits.empty()) return;
  out +=
      "<h3>Fits</h3>\n<div class=\"wide\">\n<table class=\"list\">\n<thead><tr><th>scheme</th><th>quantity</th><th "
      "class=\"n\">order</th><th>interval</th>"
      "<th class=\"n\">claimed</th><th>verdict</th><th>levels</th></tr></thead>\n<tbody>\n";
  for (const auto* f : fits) {
    const auto* v = verdict_on(r, *f);
    put(out,
        "<tr class=\"fit\"><th scope=\"row\">{}</th><td>{}</td><td class=\"n\">{}</td><td class=\"i\">{}</td><td "
        "class=\"n\">{}</td><td>{}</td><td class=\"why\">{}</td></tr>\n",
        escape_html(f->scheme), escape_html(joined(f->quantity, f->observable)), shown_order(f->order),
        shown_order_interval(f->low, f->high), v == nullptr ? "–" : shown(v->expected),
        v == nullptr ? "–" : chip(v->kind), escape_html(f->rule));
  }
  out += "</tbody>\n</table>\n</div>\n";
}

std::string use_of(const measurement& m) {
  const auto status = status_of(m);
  return status != "ok" ? escape_html(status) : m.fitted ? "in the fit" : "";
}

void put_measurements(std::string& out, const results& r, const std::string& name) {
  std::size_t total = 0;
  for (const auto& m : r.measurements) total += m.experiment == name ? 1 : 0;
  if (total == 0) {
    out += "<p class=\"note\">Nothing was measured here.</p>\n";
    return;
  }
  put(out,
      "<details>\n<summary>{} measurement{}</summary>\n<div class=\"wide\">\n<table "
      "class=\"list\">\n<thead><tr><th>scheme</th><th>quantity</th><th class=\"n\">dt</th>"
      "<th class=\"n\">steps</th><th "
      "class=\"n\">value</th><th>interval</th><th>unit</th><th>method</th><th>use</th></tr></thead>\n<tbody>\n",
      total, total == 1 ? "" : "s");
  std::size_t shown_rows = 0;
  for (const auto& m : r.measurements) {
    if (m.experiment != name || shown_rows++ >= most_rows) continue;
    put(out,
        "<tr><th scope=\"row\">{}</th><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td "
        "class=\"n\">{}</td><td class=\"i\">{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
        escape_html(m.scheme), escape_html(joined(m.quantity, m.observable)), shown(m.dt), shown(m.steps),
        shown(m.value), shown_interval(m.low, m.high), escape_html(m.unit), escape_html(m.method), use_of(m));
  }
  out += "</tbody>\n</table>\n</div>\n";
  if (total > most_rows)
    put(out, "<p class=\"key\">The first {}; all of them are in measurements.csv.</p>\n", most_rows);
  out += "</details>\n";
}

}  // namespace

void put_experiment(std::string& out, const results& r, const std::string& name, std::size_t index) {
  const auto rows = verdicts_of(r, name);
  const auto* declared = find_experiment(r, name);
  put(out, "<section class=\"experiment\" id=\"experiment-{}\">\n<h2>{}</h2>\n", index, escape_html(name));
  put_question(out, declared);
  put_facts(out, r, name);
  put_plots_and_claims(out, r, name, rows);
  put_maps(out, r, name);
  put_tables(out, r, name);
  put_cost_table(out, r, name);
  put_fits(out, r, name);
  put_verdicts(out, rows);
  put_measurements(out, r, name);
  for (const auto& one : r.skipped)
    if (one.experiment == name)
      put(out, "<p class=\"note\">{} Skipped for {}: {}</p>\n", symbol_of(verdict_kind::skipped),
          one.scheme.empty() ? "every scheme" : escape_html(one.scheme), escape_html(one.reason));
  out += "</section>\n";
}

}  // namespace polhode::report::html
