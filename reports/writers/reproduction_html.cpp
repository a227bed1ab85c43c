// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/reproduction_html.hpp"

#include <fmt/format.h>

#include "reports/writers/reproduction_numbers.hpp"
#include "reports/writers/reproduction_plot.hpp"
#include "reports/writers/text.hpp"

namespace polhode::report {
namespace {

constexpr std::string_view style = R"css(
:root { --page: #fbfaf7; --card: #fff; --ink: #1f2328; --soft: #57606a; --rule: #d9d6ce; --agrees: #0b6b4f;
  --explained: #805500; --differs: #b02a0c; --line: #0a5fa8; color-scheme: light dark; }
@media (prefers-color-scheme: dark) {
  :root { --page: #131619; --card: #1a1e23; --ink: #e6e8eb; --soft: #a3abb5; --rule: #343b44; --agrees: #4cc9a0;
    --explained: #e0b04a; --differs: #ff8763; --line: #74b9f0; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--page); color: var(--ink); overflow-wrap: anywhere;
  font: 16px/1.5 system-ui, -apple-system, 'Segoe UI', Roboto, Arial, sans-serif; }
main { max-width: 1080px; margin: 0 auto; padding: 18px clamp(12px, 3vw, 36px) 64px; }
h1, h2 { font-family: Charter, Cambria, Georgia, 'Noto Serif', serif; line-height: 1.15; margin: 0 0 0.3em; }
section { border-top: 1px solid var(--rule); margin-top: 32px; padding-top: 24px; }
a { color: var(--line); }
.soft, small, li { color: var(--soft); }
small, li, .soft { font-size: 14px; }
table { border-collapse: collapse; width: 100%; margin: 14px 0; background: var(--card); }
th, td { text-align: left; vertical-align: top; padding: 7px 10px; border-bottom: 1px solid var(--rule); }
th { font-size: 13px; color: var(--soft); font-weight: 600; }
td.number { white-space: nowrap; font-variant-numeric: tabular-nums; }
td small { display: block; }
.agrees { color: var(--agrees); } .explained { color: var(--explained); } .differs { color: var(--differs); }
td.verdict { font-weight: 600; white-space: nowrap; }
pre { background: var(--card); border: 1px solid var(--rule); padding: 10px; overflow-x: auto; font-size: 13px; }
.curves { display: flex; flex-wrap: wrap; gap: 16px; }
figure { margin: 0; flex: 1 1 320px; max-width: 500px; background: var(--card); border: 1px solid var(--rule);
  padding: 10px; }
figcaption { font-size: 14px; } svg { width: 100%; height: auto; display: block; }
svg .published { fill: none; stroke: var(--line); stroke-width: 2; } svg .ours { fill: var(--card); stroke: var(--agrees);
  stroke-width: 2; } svg .axis { fill: none; stroke: var(--soft); } svg .grid { stroke: var(--rule); }
svg .tick, svg .name { fill: var(--soft); font-size: 11px; }
.key::before { content: ''; display: inline-block; width: 20px; margin-right: 6px; vertical-align: middle; }
.key.line::before { border-top: 2px solid var(--line); } .key.dots::before { width: 9px; height: 9px;
  border: 2px solid var(--agrees); border-radius: 50%; } .key { margin-right: 14px; color: var(--soft); font-size: 13px; }
@media (max-width: 720px) {
  thead { display: none; } tr { display: block; border-bottom: 1px solid var(--rule); padding: 8px 0; }
  td, td.number, td.verdict { display: block; border: 0; padding: 2px 10px; white-space: normal; }
  td[data-name]::before { content: attr(data-name) ' '; color: var(--soft); font-size: 13px; font-weight: 400; } }
)css";

std::string_view class_of(agreement kind) {
  switch (kind) {
    case agreement::agrees: return "agrees";
    case agreement::explained: return "explained";
    case agreement::differs: return "differs";
  }
  return "differs";
}

std::string number_row(const reproduced_number& n) {
  const auto off = shown_difference(n);
  const auto why = n.why.empty() ? "" : fmt::format("<small>{}</small>", escape_html(n.why));
  return fmt::format(
      "<tr><td>{}{}</td><td class=\"number\" data-name=\"published\">{}</td><td class=\"number\" "
      "data-name=\"ours\">{}</td><td class=\"verdict {}\">{}{}</td></tr>\n",
      escape_html(n.quantity), why, shown_published(n), shown_ours(n), class_of(n.verdict), name_of(n.verdict),
      off.empty() ? "" : fmt::format("<small>{}</small>", off));
}

std::string figure_of(const reproduced_curve& c) {
  const auto drawn = to_svg(c);
  if (drawn.empty()) return "";
  return fmt::format(
      "<figure><figcaption>{}</figcaption>{}<span class=\"key line\">{}</span><span class=\"key "
      "dots\">{}</span></figure>\n",
      escape_html(c.title), drawn, escape_html(c.published), escape_html(c.ours));
}

std::string section_of_case(const reproduction& r) {
  auto out = fmt::format(
      "<section id=\"{0}\"><h2>{1}</h2>\n<p><strong class=\"{2}\">{3}</strong>: {4}. <code>polhode reproduce "
      "{0}</code></p>\n<p class=\"soft\">Source: {5}.</p>\n<table><thead><tr><th>quantity</th><th>published</th>"
      "<th>ours</th><th>verdict</th></tr></thead><tbody>\n",
      escape_html(r.name), escape_html(r.title), class_of(r.verdict()), name_of(r.verdict()), sentence(r),
      escape_html(r.source));
  for (const auto& n : r.numbers) out += number_row(n);
  out += "</tbody></table>\n<div class=\"curves\">\n";
  for (const auto& c : r.curves) out += figure_of(c);
  out += "</div>\n<ul>\n";
  for (const auto& note : r.notes) out += fmt::format("<li>{}</li>\n", escape_html(note));
  out += "</ul>\n";
  if (!r.scene.empty())
    out += fmt::format("<details><summary>The scene</summary><pre>{}</pre></details>\n", escape_html(r.scene));
  return out + "</section>\n";
}

}  // namespace

std::string to_html(std::span<const reproduction> all) {
  std::string list, sections;
  for (const auto& r : all) {
    list += fmt::format(
        "<tr><td><a href=\"#{0}\">{0}</a><small>{1}</small></td><td>{2}</td><td class=\"verdict {3}\">{4}</td></tr>\n",
        escape_html(r.name), escape_html(r.title), sentence(r), class_of(r.verdict()), name_of(r.verdict()));
    sections += section_of_case(r);
  }
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<meta http-equiv=\"Content-Security-Policy\" "
      "content=\"default-src 'none'; style-src 'unsafe-inline'\">\n<title>Published figures, run again · "
      "polhode</title>\n<style>{}</style>\n</head>\n<body>\n<main>\n<h1>Published figures, run again</h1>\n<p>A number "
      "agrees where ours, with all of its interval, lies in what the published one allows.</p>\n<table><thead><tr>"
      "<th>case</th><th>numbers</th><th>verdict</th></tr></thead><tbody>\n{}</tbody></table>\n{}</main>\n</body>\n"
      "</html>\n",
      style, list, sections);
}

}  // namespace polhode::report
