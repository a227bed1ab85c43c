// Colours after Okabe and Ito, which every kind of colour vision tells apart; lighter ones on dark paper.
#include "reports/writers/svg_plot.hpp"

namespace polhode::report {

std::string_view plot_style() {
  return R"css(.plot {
  --paper: #fff; --ink: #1f2328; --soft: #57606a; --line: #8c959f; --grid: #e4e7eb;
  --c0: #0072b2; --c1: #c8500a; --c2: #00805c; --c3: #b0508c; --c4: #a87400; --c5: #2f93c8; --c6: #5b5f66;
  font: 13px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif;
  font-variant-numeric: tabular-nums;
  display: block; width: 100%; height: auto; overflow: visible;
}
@media screen and (prefers-color-scheme: dark) {
  .plot {
    --paper: #1a1e23; --ink: #e6e8eb; --soft: #a3abb5; --line: #6b7480; --grid: #2c323a;
    --c0: #5aaeea; --c1: #f08a4b; --c2: #35bd95; --c3: #e08dbd; --c4: #e0ac3a; --c5: #8fd0f5; --c6: #b4bac2;
  }
}
@media (max-width: 600px) { .plot { font-size: 14px; } }
.plot text { fill: var(--ink); }
.plot .soft { fill: var(--soft); }
.plot .small { font-size: 11.5px; }
.plot .paper { fill: var(--paper); }
.plot .frame { fill: none; stroke: var(--line); }
.plot .grid { stroke: var(--grid); }
.plot .tick { stroke: var(--line); }
.plot .guide { stroke: var(--soft); stroke-width: 1.2; stroke-dasharray: 5 4; opacity: .75; }
.plot .level { stroke: var(--ink); stroke-width: 1.2; stroke-dasharray: 1.5 3; }
.plot .halo { paint-order: stroke; stroke: var(--paper); stroke-width: 4px; stroke-linejoin: round; }
.plot .line { fill: none; stroke: currentColor; stroke-width: 1.5; }
.plot .thin { stroke-width: 1; opacity: .7; }
.plot .bar { fill: none; stroke: currentColor; stroke-width: 1.1; }
.plot .dot { fill: currentColor; stroke: var(--paper); stroke-width: .8; }
.plot .cell { shape-rendering: crispEdges; }
.plot .under { fill: none; stroke: #fff; stroke-width: 4.5; stroke-linejoin: round; }
.plot .over { fill: none; stroke: #1f2328; stroke-width: 1.8; stroke-linejoin: round; }
.plot .mark { fill: #1f2328; stroke: #fff; stroke-width: 1; }
.plot .hollow { fill: var(--paper); stroke: currentColor; stroke-width: 1.4; }
.plot .c0 { color: var(--c0); } .plot .c1 { color: var(--c1); } .plot .c2 { color: var(--c2); }
.plot .c3 { color: var(--c3); } .plot .c4 { color: var(--c4); } .plot .c5 { color: var(--c5); }
.plot .c6 { color: var(--c6); }
.plot .all:hover .series { opacity: .15; }
.plot .all .series:hover { opacity: 1; }
)css";
}

}  // namespace polhode::report
