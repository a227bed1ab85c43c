#include "reports/writers/svg_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "reports/writers/numbers.hpp"
#include "reports/writers/svg_canvas.hpp"
#include "reports/writers/text.hpp"

namespace polhode::report {
namespace {

using colour = std::array<double, 3>;
constexpr colour above{0, 86, 156}, below{196, 78, 0};  // after Okabe and Ito, darkened for the depth of the scale
constexpr double scale_top = frame::bottom + 56, scale_height = 12;
constexpr int scale_steps = 40;

/// From -1 to 1; the sign is the value's.
double depth(double value, double most) {
  return most > 0 ? std::copysign(std::sqrt(std::abs(value / most)), value) : 0;
}

std::string paint(double depth) {
  const colour& full = depth < 0 ? below : above;
  const double share = std::min(1.0, std::abs(depth));
  const auto mix = [&](std::size_t k) { return static_cast<int>(std::lround(255 + share * (full[k] - 255))); };
  return fmt::format("#{:02x}{:02x}{:02x}", mix(0), mix(1), mix(2));
}

/// The edges of cells in one direction: half way between neighbours (of the logarithms where logarithmic), and as far
/// beyond the ends; not below zero for values that are not.
struct edges {
  std::vector<double> centres, ends;

  edges(std::vector<double> values, bool logarithmic) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    centres = std::move(values);
    const auto between = [&](double a, double b) { return logarithmic ? std::sqrt(a) * std::sqrt(b) : a / 2 + b / 2; };
    const auto beyond = [&](double inner, double end) {
      return logarithmic ? end * (end / inner) : end + (end - inner);
    };
    if (centres.size() < 2) {
      const double c = centres.empty() ? 1 : centres[0], air = c == 0 ? 1 : std::abs(c) / 2;
      ends = {c - air, c + air};
      return;
    }
    const std::size_t n = centres.size();
    double first = between(beyond(centres[1], centres[0]), centres[0]);
    if (centres[0] >= 0) first = std::max(first, 0.0);
    ends.push_back(first);
    for (std::size_t i = 0; i + 1 < n; ++i) ends.push_back(between(centres[i], centres[i + 1]));
    ends.push_back(between(centres[n - 1], beyond(centres[n - 2], centres[n - 1])));
  }
  std::size_t index(double value) const {
    return static_cast<std::size_t>(std::lower_bound(centres.begin(), centres.end(), value) - centres.begin());
  }
};

template <class Value>
std::vector<double> all_of(const value_map& m, const Value& value) {
  std::vector<double> all;
  for (const auto& cell : m.cells) all.push_back(value(cell));
  return all;
}

struct map_canvas : frame {
  const value_map& content;
  edges columns, rows;
  axis x, y;
  double most = 0;

  explicit map_canvas(const value_map& m)
      : content(m),
        columns(all_of(m, [](const map_cell& c) { return c.x; }), m.log_x),
        rows(all_of(m, [](const map_cell& c) { return c.y; }), m.log_y),
        x(m.log_x, columns.ends, true),
        y(m.log_y, rows.ends, true) {
    static_cast<frame&>(*this) = place_in_frame(x, y);
    for (const auto& cell : m.cells) most = std::max(most, std::abs(finite(cell.value).value_or(0)));
  }
};

void put_cells(std::string& out, const map_canvas& c) {
  for (const auto& cell : c.content.cells) {
    const std::size_t i = c.columns.index(cell.x), j = c.rows.index(cell.y);
    const double left = c.x(c.columns.ends[i]), right = c.x(c.columns.ends[i + 1]);
    const double top = c.y(c.rows.ends[j + 1]), bottom = c.y(c.rows.ends[j]);
    const auto value = finite(cell.value);
    // A little wider than it is: no paper shines through between neighbours.
    put(out, "<rect class=\"cell{}\" fill=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\">",
        value ? "" : " unknown", value ? paint(depth(*value, c.most)) : "#9aa1a9", left, top, right - left + 0.3,
        bottom - top + 0.3);
    put(out, "<title>{} {}, {} {}: {} {}</title></rect>\n", escape_html(c.content.x_title), shown(cell.x),
        escape_html(c.content.y_title), shown(cell.y), escape_html(c.content.value_title),
        value ? shown(*value) : escape_html(cell.status));
  }
}

void put_curve(std::string& out, const map_canvas& c, const map_curve& curve) {
  std::string path;
  for (const auto& p : curve.points)
    if (std::isfinite(p.x) && std::isfinite(p.y))
      put(path, "{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L', c.x(p.x), c.y(p.y));
  if (path.empty()) return;
  put(out, "<path class=\"under\" d=\"{0}\"/>\n<path class=\"over\" d=\"{0}\"/>\n", path);
  for (const auto& p : curve.points)
    put(out,
        "<circle class=\"mark\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\"><title>{} at {} {}: {} {} {}</title></circle>\n",
        c.x(p.x), c.y(p.y), escape_html(curve.name), escape_html(c.content.x_title), shown(p.x),
        escape_html(c.content.y_title), shown(p.y), shown_interval(p.low, p.high));
}

/// A bar from -most to most, even in the depth of the colour, with the values that belong to it.
void put_scale(std::string& out, const map_canvas& c) {
  const double width = c.right - c.left, step = width / scale_steps;
  for (int i = 0; i < scale_steps; ++i)
    put(out, "<rect class=\"cell\" fill=\"{}\" x=\"{:.1f}\" y=\"{}\" width=\"{:.1f}\" height=\"{}\"/>\n",
        paint((2 * i + 1.0) / scale_steps - 1), c.left + i * step, scale_top, step + 0.3, scale_height);
  put(out, "<rect class=\"frame\" x=\"{:.1f}\" y=\"{}\" width=\"{:.1f}\" height=\"{}\"/>\n", c.left, scale_top, width,
      scale_height);
  for (const double d : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
    const double x = c.left + (d + 1) / 2 * width;
    put(out,
        "<path class=\"tick\" d=\"M{:.1f} {}v4\"/>\n<text class=\"small\" x=\"{:.1f}\" y=\"{}\" "
        "text-anchor=\"{}\">{}</text>\n",
        x, scale_top + scale_height, x, scale_top + scale_height + 16,
        d == -1  ? "start"
        : d == 1 ? "end"
                 : "middle",
        fmt::format("{:.2g}", d * std::abs(d) * c.most));
  }
}

void put_key(std::string& out, const map_canvas& c, double y) {
  double x = 10;
  for (const auto& curve : c.content.curves) {
    put(out, "<path class=\"under\" d=\"M{0:.1f} {1:.1f}h22\"/><path class=\"over\" d=\"M{0:.1f} {1:.1f}h22\"/>", x, y);
    put(out, "<circle class=\"mark\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\"/><text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
        x + 11, y, x + 28, y + 4.5, escape_html(shortened(curve.name, longest_name)));
    x += 200;
  }
  put(out, "<text class=\"soft small\" x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{}, colour by its root</text>\n",
      c.right, y + 4.5, escape_html(shortened(c.content.value_title, 20)));
}

}  // namespace

std::string to_svg(const value_map& m, svg_use use) {
  const map_canvas c(m);
  const double key = scale_top + scale_height + 34, height = key + 12;
  std::string out;
  put_svg_head(out, m.title, height, use);
  put_paper(out, c);
  put_cells(out, c);
  put_ticks(out, c, c.x, c.y, false);
  for (const auto& curve : m.curves) put_curve(out, c, curve);
  put_frame(out, c, m.x_title, m.y_title);
  put_scale(out, c);
  put_key(out, c, key);
  return out + "</svg>\n";
}

}  // namespace polhode::report
