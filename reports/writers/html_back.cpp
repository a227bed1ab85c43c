// The end of the page: what the schemes claim, what was skipped and why, and where the numbers come from.
#include "reports/writers/html_parts.hpp"
#include "reports/writers/left_out.hpp"
#include "reports/writers/numbers.hpp"
#include "reports/writers/text.hpp"

namespace polhode::report::html {
namespace {

std::string casimir(const scheme& s) {
  return s.casimir_exact ? "exact" : fmt::format("drifts, order {}", shown(s.casimir_order));
}

void put_fact(std::string& out, std::string_view term, const std::string& value) {
  put(out, "<div><dt>{}</dt><dd>{}</dd></div>\n", term, value.empty() ? "–" : escape_html(value));
}

std::string_view class_of(enum left_out::kind kind) {
  return kind == left_out::kind::skip ? "skip" : kind == left_out::kind::saving ? "saving" : "reuse";
}

}  // namespace

void put_schemes(std::string& out, const results& r) {
  if (r.schemes.empty()) return;
  out +=
      "<section>\n<h2>What the schemes claim</h2>\n<div class=\"wide\">\n<table class=\"list\">\n<thead>"
      "<tr><th rowspan=\"2\">scheme</th><th rowspan=\"2\">form</th><th colspan=\"2\" class=\"n\">strong order</th>"
      "<th rowspan=\"2\" class=\"n\">order<br>without noise</th><th rowspan=\"2\">Casimir</th><th "
      "rowspan=\"2\">source</th></tr>\n"
      "<tr><th class=\"n\">commuting</th><th class=\"n\">general</th></tr></thead>\n<tbody>\n";
  for (const auto& s : r.schemes)
    put(out,
        "<tr class=\"scheme\"><th scope=\"row\">{}<br><small>{}</small></th><td>{}, {}{}</td><td "
        "class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td>{}</td><td class=\"why\">{}</td></tr>\n",
        escape_html(s.name), escape_html(s.title),
        s.calculus == "ito"            ? "Itô"
        : s.calculus == "stratonovich" ? "Stratonovich"
                                       : escape_html(s.calculus),
        s.implicit ? "implicit" : "explicit", s.areas ? ", Lévy areas" : "", shown(s.strong_commuting),
        shown(s.strong_general), s.deterministic_order, casimir(s), escape_html(s.source));
  out += "</tbody>\n</table>\n</div>\n</section>\n";
}

void put_left_out(std::string& out, const results& r) {
  put(out, "<section>\n<h2>What was not computed, and why</h2>\n<p class=\"key\">{}</p>\n", work_sentence(r));
  if (const auto rows = left_out_of(r); !rows.empty()) {
    out +=
        "<div class=\"wide\">\n<table class=\"list\">\n"
        "<thead><tr><th>experiment</th><th>scheme</th><th>reason</th><th>saved</th></tr></thead>\n<tbody>\n";
    for (const auto& row : rows)
      put(out, "<tr class=\"{}\"><th scope=\"row\">{}</th><td>{}</td><td class=\"why\">{}</td><td>{}</td></tr>\n",
          class_of(row.kind), escape_html(row.experiment), escape_html(row.schemes), escape_html(row.reason),
          row.saved.empty() ? "–" : row.saved);
    out += "</tbody>\n</table>\n</div>\n";
  }
  out += "</section>\n";
}

void put_provenance(std::string& out, const provenance& p) {
  out += "<footer>\n<h2>Provenance</h2>\n<dl class=\"facts\">\n";
  put_fact(out, "polhode", p.version);
  put_fact(out, "commit", p.commit);
  put_fact(out, "compiler", p.compiler);
  put_fact(out, "flags", p.flags);
  put_fact(out, "CPU", p.cpu);
  put_fact(out, "instruction set", p.isa);
  put_fact(out, "random bits", p.generator);
  put_fact(out, "threads", std::to_string(p.threads));
  put_fact(out, "seed", std::to_string(p.seed));
  put_fact(out, "effort", p.effort);
  put_fact(out, "started", p.started);
  put_fact(out, "wall time", shown_duration(p.wall_seconds));
  put_fact(out, "CPU time", shown_duration(p.cpu_seconds));
  out +=
      "</dl>\n<p class=\"key\">Every number of this page is in results.json, measurements.csv and verdicts.csv beside "
      "it.</p>\n</footer>\n";
}

}  // namespace polhode::report::html
