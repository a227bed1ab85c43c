#include "reports/writers/heat_map.hpp"

#include <algorithm>
#include <cmath>

#include "reports/writers/numbers.hpp"
#include "reports/writers/svg_axis.hpp"
#include "reports/writers/svg_canvas.hpp"
#include "reports/writers/text.hpp"

namespace polhode::report {
namespace {

constexpr double width = 300, height = 208, right = 292, top = 8, bottom = 164, left = 62;

/// Where the cells of these centres begin and end: half way between neighbours, on a logarithmic axis.
std::vector<double> edges_of(const std::vector<double>& centres) {
  const std::size_t n = centres.size();
  std::vector<double> edges(n + 1);
  for (std::size_t i = 1; i < n; ++i) edges[i] = std::sqrt(centres[i - 1] * centres[i]);
  const double first = n > 1 ? std::sqrt(centres[1] / centres[0]) : 2;
  const double last = n > 1 ? std::sqrt(centres[n - 1] / centres[n - 2]) : 2;
  edges[0] = centres[0] / first;
  edges[n] = centres[n - 1] * last;
  return edges;
}

struct map_frame {
  std::vector<double> columns, rows;  // edges
  axis x, y;

  explicit map_frame(const heat_map& m)
      : columns(edges_of(m.columns)), rows(edges_of(m.rows)), x(true, columns), y(true, rows) {
    x.place_between(left, right);
    y.place_between(bottom, top);
  }
};

std::size_t index_of(const std::vector<double>& all, double value) {
  return static_cast<std::size_t>(std::ranges::find(all, value) - all.begin());
}

void put_cells(std::string& out, const heat_map& m, const map_frame& f) {
  for (const auto& cell : m.cells) {
    const auto i = index_of(m.columns, cell.x), k = index_of(m.rows, cell.y);
    const double x0 = f.x(f.columns[i]), x1 = f.x(f.columns[i + 1]), y0 = f.y(f.rows[k + 1]), y1 = f.y(f.rows[k]);
    put(out,
        "<g><title>{} {}, {} {}: {} {}</title><rect class=\"cell\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" "
        "height=\"{:.1f}\" fill-opacity=\"{:.2f}\"/>",
        escape_html(m.x_title), shown(cell.x), escape_html(m.y_title), shown(cell.y), shown(cell.value),
        escape_html(cell.remark), x0, y0, x1 - x0, y1 - y0, 0.1 + 0.8 * (1 - std::clamp(cell.value, 0.0, 1.0)));
    if (!cell.remark.empty())
      put(out, "<path class=\"cross\" d=\"M{:.1f} {:.1f}l5 5m0-5l-5 5\"/>", (x0 + x1) / 2 - 2.5, (y0 + y1) / 2 - 2.5);
    out += "</g>\n";
  }
}

/// Where the border is drawn at this point: between its ends, or at the one that is there.
double place_of(const border_point& p) {
  return p.low && p.high ? std::sqrt(*p.low * *p.high) : p.low ? *p.low : *p.high;
}

// A point between both ends; an arrowhead where the border lies beyond what was tried.
const char* outline_of(const border_point& p) {
  if (!p.high) return "m-3-5l8 5-8 5z";
  if (!p.low) return "m3-5l-8 5 8 5z";
  return "m-3.5 0a3.5 3.5 0 1 0 7 0a3.5 3.5 0 1 0-7 0z";
}

void put_border(std::string& out, const heat_map& m, const map_frame& f) {
  std::string line, marks;
  for (const auto& p : m.border) {
    if (!p.low && !p.high) continue;
    const double x = f.x(place_of(p)), y = f.y(p.y);
    put(line, "{}{:.1f} {:.1f}", line.empty() ? 'M' : 'L', x, y);
    put(marks, "<path class=\"mark\" d=\"M{:.1f} {:.1f}{}\"><title>{} {}: {} {} {}</title></path>\n", x, y,
        outline_of(p), escape_html(m.y_title), shown(p.y), escape_html(m.x_title),
        p.low && p.high ? shown_interval(p.low, p.high) : shown(place_of(p)), escape_html(p.remark));
  }
  if (line.empty()) return;
  put(out, "<path class=\"border under\" d=\"{0}\"/><path class=\"border\" d=\"{0}\"/>\n{1}", line, marks);
}

void put_frame(std::string& out, const heat_map& m, const map_frame& f) {
  for (const auto& t : f.x.ticks()) {
    put(out, "<path class=\"tick\" d=\"M{:.1f} {:.1f}v{}\"/>\n", t.place, bottom, t.label.empty() ? 2 : 4);
    if (!t.label.empty())
      put(out, "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n", t.place, bottom + 17, t.label);
  }
  for (const auto& t : f.y.ticks()) {
    put(out, "<path class=\"tick\" d=\"M{:.1f} {:.1f}h-{}\"/>\n", left, t.place, t.label.empty() ? 2 : 4);
    if (!t.label.empty())
      put(out, "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n", left - 7, t.place + 4.5, t.label);
  }
  put(out, "<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n", left, top, right - left,
      bottom - top);
  put(out, "<text class=\"soft\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", (left + right) / 2, height - 8,
      escape_html(shortened(m.x_title, 30)));
  put(out, "<text class=\"soft\" transform=\"translate(13 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
      (top + bottom) / 2, escape_html(shortened(m.y_title, 20)));
}

}  // namespace

std::string to_svg(const heat_map& m) {
  const map_frame f(m);
  std::string out;
  put(out, "<svg class=\"plot heat\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{} over {} and {}\">\n", width,
      height, escape_html(m.title), escape_html(m.x_title), escape_html(m.y_title));
  put_cells(out, m, f);
  put_border(out, m, f);
  put_frame(out, m, f);
  return out + "</svg>\n";
}

// One hue from light to dark and a border of another lightness: told apart by every kind of colour vision, and in grey.
std::string_view heat_map_style() {
  return R"css(.heat .cell { fill: var(--c0); stroke: var(--paper); stroke-width: .8; }
.heat .cross { fill: none; stroke: var(--soft); stroke-width: 1.3; }
.heat .border { fill: none; stroke: var(--c1); stroke-width: 2.4; }
.heat .under { stroke: var(--paper); stroke-width: 5; }
.heat .mark { fill: var(--c1); stroke: var(--paper); stroke-width: 1.2; }
.maps { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 250px), 1fr)); gap: 16px; margin: 14px 0; }
.maps figure { padding: 10px 8px 4px; } .maps figcaption { font: 13px/1.4 var(--mono); margin: 0 0 6px 8px; }
)css";
}

}  // namespace polhode::report
