#include "reports/writers/html_parts.hpp"

namespace polhode::report::html {

std::string_view page_style() {
  return R"css(:root {
  --page: #fbfaf7; --card: #fff; --ink: #1f2328; --soft: #57606a; --rule: #d9d6ce; --link: #0a5fa8;
  --holds: #0b6b4f; --refuted: #b02a0c; --inconclusive: #805500; --skipped: #5d6670;
  --serif: Charter, "Bitstream Charter", "Sitka Text", Cambria, Georgia, "Noto Serif", serif;
  --sans: system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif;
  --mono: ui-monospace, "SF Mono", SFMono-Regular, Menlo, Consolas, "DejaVu Sans Mono", monospace;
}
@media screen and (prefers-color-scheme: dark) {
  :root {
    --page: #131619; --card: #1a1e23; --ink: #e6e8eb; --soft: #a3abb5; --rule: #343b44; --link: #74b9f0;
    --holds: #4cc9a0; --refuted: #ff8763; --inconclusive: #e0b04a; --skipped: #a3abb5;
  }
}
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; scroll-behavior: smooth; }
body { margin: 0; background: var(--page); color: var(--ink); font: 17px/1.55 var(--serif); overflow-wrap: break-word; }
main { max-width: 1180px; margin: 0 auto; padding: clamp(20px, 4vw, 56px) clamp(16px, 4vw, 40px) 64px; }
p { margin: .5em 0; }
a { color: var(--link); text-decoration-thickness: 1px; text-underline-offset: 2px; }
h1 { font-size: clamp(32px, 6vw, 54px); line-height: 1.1; margin: 0 0 .5em; font-weight: 600; letter-spacing: -.015em; overflow-wrap: anywhere; }
h2 { font-size: 27px; line-height: 1.2; margin: 0 0 .4em; font-weight: 600; overflow-wrap: anywhere; }
h3 { font: 600 13px/1.3 var(--sans); letter-spacing: .06em; text-transform: uppercase; color: var(--soft); margin: 2.2em 0 .7em; }
section, footer { margin-top: 56px; }
.experiment, footer { border-top: 1px solid var(--rule); padding-top: 40px; }
.over, .key, .note, dl, table, figcaption, summary { font-family: var(--sans); }
.over { font-size: 14px; letter-spacing: .04em; color: var(--soft); margin: 0 0 .6em; }
.soft { color: var(--soft); }
.key, .note { font-size: 14px; color: var(--soft); max-width: 90ch; }
.verdict { border-left: 6px solid var(--skipped); padding: 2px 0 2px 20px; }
.verdict p { margin: 0; color: var(--soft); font: 16px/1.5 var(--sans); }
.verdict .headline { font: 600 clamp(22px, 3.4vw, 30px)/1.25 var(--serif); color: var(--ink); margin-bottom: 4px; }
.verdict.holds { border-color: var(--holds); } .verdict.refuted { border-color: var(--refuted); }
.verdict.inconclusive { border-color: var(--inconclusive); }
.open { list-style: none; margin: 18px 0 0; padding: 0; font: 15px/1.5 var(--sans); } .open li { margin: 4px 0; }
.open a { font-family: var(--mono); font-size: 14px; }
.scene { margin-top: 36px; display: grid; gap: 20px; }
.equation { font-size: clamp(16px, 2.4vw, 20px); line-height: 1.7; }
.equation .soft { font-size: .85em; }
.equation span { white-space: nowrap; }
.stack { display: inline-block; vertical-align: middle; line-height: 1; font-size: .68em; }
.stack sup, .stack sub { display: block; font-size: 1em; line-height: .95; vertical-align: baseline; }
sub, sup { font-size: .7em; line-height: 0; }
.facts { display: flex; flex-wrap: wrap; gap: 14px 36px; margin: 0; font-size: 15px; line-height: 1.4; }
.facts div { min-width: 0; max-width: 100%; }
.facts dt { color: var(--soft); font-size: 13px; }
.facts dd { margin: 0; font-variant-numeric: tabular-nums; overflow-wrap: anywhere; }
.wide { overflow-x: auto; border: 1px solid var(--rule); border-radius: 8px; background: var(--card); margin: 14px 0; }
table { border-collapse: separate; border-spacing: 0; width: 100%; font-size: 14px; line-height: 1.4; font-variant-numeric: tabular-nums; }
th, td { padding: 7px 14px; text-align: left; vertical-align: baseline; border-top: 1px solid var(--rule); }
thead tr:first-child th { border-top: 0; }
thead th { font-weight: 600; color: var(--soft); vertical-align: bottom; white-space: nowrap; }
tbody th { font: 13px/1.4 var(--mono); white-space: nowrap; position: sticky; left: 0; background: var(--card); max-width: 46vw; overflow: hidden; text-overflow: ellipsis; }
tbody th small { font: 12.5px/1.4 var(--sans); color: var(--soft); }
tbody tr:hover > * { background: color-mix(in srgb, var(--card), var(--ink) 4%); }
.n { text-align: right; white-space: nowrap; } .i, .board td { white-space: nowrap; }
.i { color: var(--soft); }
.why { color: var(--soft); min-width: 22ch; }
.none { color: var(--soft); }
.cross td { white-space: nowrap; } .cross td small { color: var(--soft); } .cross thead th { white-space: normal; min-width: 8ch; }
.board thead th { white-space: normal; min-width: 9ch; }
.chip { display: inline-block; white-space: nowrap; color: var(--ink); }
.chip b { display: inline-block; width: 1.5em; text-align: center; border-radius: 4px; margin-right: .25em; color: var(--card); background: currentColor; }
.chip + .chip { margin-left: 10px; }
.chip { font-weight: 500; } .chip small { color: var(--soft); font-size: 1em; }
.chip.holds b { color: var(--holds); } .chip.refuted b { color: var(--refuted); }
.chip.inconclusive b { color: var(--inconclusive); } .chip.skipped b { color: var(--skipped); }
.chip b { background: none; box-shadow: inset 0 0 0 1.5px currentColor; }
.chip.refuted { font-weight: 700; }
.chip.skipped, .chip.holds { color: var(--soft); }
.question { font-size: 20px; line-height: 1.45; font-style: italic; max-width: 62ch; margin: 0 0 .8em; }
.notes { margin: 0 0 1.5em; padding-left: 1.1em; max-width: 78ch; color: var(--soft); font-size: 16px; }
.plots { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 420px), 1fr)); gap: 28px; margin: 24px 0; }
.plots .wide { margin: 0; align-self: start; min-width: 0; }
figure { margin: 0; min-width: 0; max-width: 560px; padding: 16px 16px 12px; background: var(--card); border: 1px solid var(--rule); border-radius: 8px; break-inside: avoid; }
figcaption { font-size: 15px; font-weight: 600; margin-bottom: 10px; overflow-wrap: anywhere; }
details { margin-top: 20px; } summary { cursor: pointer; font-size: 15px; color: var(--link); }
footer .facts { font-size: 14px; }
@media (max-width: 600px) {
  body { font-size: 16px; } section, footer { margin-top: 40px; } th, td { padding: 6px 10px; } figure { padding: 12px 4px 8px; } figcaption { padding: 0 8px; }
}
@media print {
  body { background: #fff; font-size: 10.5pt; } main { max-width: none; padding: 0; }
  .wide { overflow: visible; border: 0; } table { font-size: 8pt; } th, td { padding: 2px 6px; white-space: normal !important; } tbody th { position: static; }
  tr, figure, .verdict { break-inside: avoid; } h2, h3 { break-after: avoid; } thead { display: table-header-group; }
  .plots { grid-template-columns: 1fr 1fr; } details { display: none; } a { color: inherit; text-decoration: none; }
}
)css";
}

}  // namespace polhode::report::html
