// The top of the page: the verdict, the scene with its equation, and the board of schemes against experiments.
#include <fmt/ranges.h>

#include "reports/writers/html_parts.hpp"
#include "reports/writers/numbers.hpp"
#include "reports/writers/text.hpp"

namespace polhode::report::html {
namespace {

// One equation holds for every system; the second line is what it says on the rotations.
constexpr std::string_view equation = R"html(<div class="equation">
<p><span><i>dμ</i> = ad<span class="stack"><sup>∗</sup><sub><i>ξ</i></sub></span> <i>μ</i>,</span> &ensp;
<span><i>ξ</i> = (<i>v</i> + <i>θ</i> (ad<span class="stack"><sup>∗</sup><sub><i>v</i></sub></span> <i>μ</i>)<sup>♯</sup>) <i>dt</i>
+ Σ<sub><i>i</i></sub> <i>σ<sub>i</sub></i> ∘ <i>dW<sup>i</sup></i>,</span> &ensp; <span><i>v</i> = ∂<i>h</i>/∂<i>μ</i></span></p>
<p class="soft">on the rotations: <span><i>d</i>Π = Π × (Ω + <i>θ</i> Π × Ω) <i>dt</i>
+ Σ<sub><i>i</i></sub> Π × <i>σ<sub>i</sub></i> ∘ <i>dW<sup>i</sup></i>,</span> &ensp; <span>Ω = <i>I</i><sup>−1</sup>Π</span></p>
</div>
)html";

template <class Range>
std::string tuple(const Range& values, std::size_t most = 12) {
  std::string out = "(";
  std::size_t count = 0;
  for (const auto& value : values) {
    if (count == most) return out + ", …)";
    out += (count++ > 0 ? ", " : "") + fmt::format("{}", value);
  }
  return out + ")";
}

std::string noise(const scene& s) {
  if (s.sigma.empty()) return "none";
  std::string out;
  for (std::size_t i = 0; i < s.sigma.size(); ++i) {
    if (i == 6) return out + fmt::format(" and {} more", s.sigma.size() - i);
    out += (i > 0 ? " " : "") + tuple(s.sigma[i]);
  }
  return out;
}

void put_fact(std::string& out, std::string_view term, const std::string& value) {
  put(out, "<div><dt>{}</dt><dd>{}</dd></div>\n", term, value);
}

void put_scene(std::string& out, const scene& s) {
  put(out, "<section class=\"scene\">\n{}<dl class=\"facts\">\n", equation);
  put_fact(out, "system", escape_html(s.system));
  put_fact(out, "inertia <i>I</i>", tuple(s.inertia));
  put_fact(out, "dissipation <i>θ</i>", fmt::format("{}", s.theta));
  put_fact(out, "noise <i>σ<sub>i</sub></i>", noise(s));
  put_fact(out, "momentum <i>μ</i><sub>0</sub>", tuple(s.momentum));
  put_fact(out, "horizon <i>T</i>", fmt::format("{}", s.horizon));
  if (!s.steps.empty()) put_fact(out, "steps to <i>T</i>", tuple(s.steps));
  out += "</dl>\n</section>\n";
}

std::string mood(const tally& t) {
  return std::string(name_of(t.refuted > 0        ? verdict_kind::refuted
                             : t.inconclusive > 0 ? verdict_kind::inconclusive
                             : t.holds > 0        ? verdict_kind::holds
                                                  : verdict_kind::skipped));
}

// What does not hold, by name, before anything else; the sections below say more.
void put_open_claims(std::string& out, const results& r) {
  constexpr std::size_t most = 12;
  const auto experiments = experiment_names(r);
  std::size_t count = 0;
  for (const auto kind : {verdict_kind::refuted, verdict_kind::inconclusive})
    for (std::size_t i = 0; i < experiments.size(); ++i)
      for (const auto* v : verdicts_of(r, experiments[i])) {
        if (v->kind != kind || ++count > most) continue;
        put(out, "{}<li>{} <a href=\"#experiment-{}\">{}</a> · {} · {}", count == 1 ? "<ul class=\"open\">\n" : "",
            chip(kind), i, escape_html(v->scheme), escape_html(v->experiment), escape_html(v->claim));
        if (finite(v->estimate)) put(out, ": found {} {}", shown(v->estimate), shown_interval(v->low, v->high));
        if (finite(v->expected)) put(out, ", claimed {}", shown(v->expected));
        out += "</li>\n";
      }
  if (count > most) put(out, "<li class=\"soft\">… and {} more below</li>\n", count - most);
  if (count > 0) out += "</ul>\n";
}

struct board_cell {
  tally counts;
  std::string claims;
};

void put_cell(std::string& out, const board_cell& cell) {
  if (cell.counts.total() == 0) {
    out += "<td class=\"none\">·</td>";
    return;
  }
  put(out, "<td title=\"{}\">", cell.claims);
  for (const auto kind : kinds_by_weight)
    if (const auto times = cell.counts.of(kind); times > 0) out += chip(kind, times);
  out += "</td>";
}

}  // namespace

std::string chip(verdict_kind kind, std::size_t times) {
  return fmt::format("<span class=\"chip {0}\"><b>{1}</b> {0}{2}</span>", name_of(kind), symbol_of(kind),
                     times > 1 ? fmt::format(" <small>×{}</small>", times) : "");
}

void put_header(std::string& out, const results& r) {
  const auto counts = count(r.verdicts);
  put(out, "<header>\n<p class=\"over\">polhode · verification report</p>\n<h1>{}</h1>\n", escape_html(r.scene.name));
  put(out, "<div class=\"verdict {}\">\n<p class=\"headline\">{}</p>\n<p>{}</p>\n</div>\n", mood(counts),
      headline(counts), sentence(counts));
  put_open_claims(out, r);
  out += "</header>\n";
  put_scene(out, r.scene);
}

// A cell counts the verdicts of one scheme in one experiment; their claims are in the experiment's own section.
void put_board(std::string& out, const results& r) {
  if (r.verdicts.empty()) return;
  const auto schemes = scheme_names(r), experiments = experiment_names(r);
  put(out,
      "<section>\n<h2>The board</h2>\n<div class=\"wide\">\n<table class=\"board\">\n<thead><tr><th "
      "scope=\"col\">scheme</th>");
  for (std::size_t i = 0; i < experiments.size(); ++i)
    if (!verdicts_of(r, experiments[i]).empty())
      put(out, "<th scope=\"col\"><a href=\"#experiment-{}\">{}</a></th>", i, escape_html(experiments[i]));
  out += "</tr></thead>\n<tbody>\n";
  for (const auto& scheme : schemes) {
    std::string row;
    bool any = false;
    for (const auto& name : experiments) {
      const auto rows = verdicts_of(r, name);
      if (rows.empty()) continue;
      board_cell cell;
      for (const auto* v : rows) {
        if (v->scheme != scheme) continue;
        cell.counts.add(v->kind);
        cell.claims +=
            fmt::format("{}{}: {}", cell.claims.empty() ? "" : "; ", escape_html(v->claim), name_of(v->kind));
      }
      any = any || cell.counts.total() > 0;
      put_cell(row, cell);
    }
    if (any) put(out, "<tr><th scope=\"row\">{}</th>{}</tr>\n", escape_html(scheme), row);
  }
  out +=
      "</tbody>\n</table>\n</div>\n<p class=\"key\">✓ holds: the interval lies inside the claim’s margin. ✗ refuted: "
      "it lies outside. ? inconclusive: "
      "neither, and no pass. – skipped: this scene cannot tell. · nothing claimed.</p>\n</section>\n";
}

}  // namespace polhode::report::html
