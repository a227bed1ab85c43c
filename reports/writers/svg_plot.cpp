#include "reports/writers/svg_plot.hpp"

#include <algorithm>

#include "reports/writers/numbers.hpp"
#include "reports/writers/svg_canvas.hpp"
#include "reports/writers/text.hpp"

namespace polhode::report {
namespace {

constexpr std::size_t colours = 7, shapes = 8;  // coprime: 56 pairs before one comes twice
constexpr double legend_top = canvas::bottom + 62, legend_row = 20;

// The outline of a marker around (0, 0).
const char* outline(std::size_t shape) {
  switch (shape % shapes) {
    case 0: return "a4 4 0 1 0 8 0a4 4 0 1 0-8 0z";
    case 1: return "m.4-3.6h7.2v7.2h-7.2z";
    case 2: return "m-.6 3.4l4.6-8 4.6 8z";
    case 3: return "m-1 0l5-5 5 5-5 5z";
    case 4: return "m-.6-3.4l4.6 8 4.6-8z";
    case 5: return "m0-4.2h8l-8 8.4h8z";
    case 6: return "m-.8 0l7.6-4.8v9.6z";
    default: return "m8.8 0l-7.6-4.8v9.6z";
  }
}

void put_marker(std::string& out, const plot_series& s, double x, double y, bool hollow) {
  put(out, "<path class=\"{}\" d=\"M{:.1f} {:.1f}{}\"", hollow ? "hollow" : "dot", x - 4, y, outline(s.style));
}

bool is_fitted(const plot_series& s) {
  return std::any_of(s.points.begin(), s.points.end(), [](const auto& p) { return p.fitted; });
}

void put_bar(std::string& out, const canvas& c, const plot_point& p) {
  if (!p.low || !p.high) return;
  const bool mirrored = c.content.log_y && p.y < 0;
  const double low = c.y(mirrored ? -*p.high : *p.low), high = c.y(mirrored ? -*p.low : *p.high);
  if (std::abs(low - high) < 2) return;  // hidden by the marker
  const double x = c.x(p.x);
  put(out, "<path class=\"bar\" d=\"M{0:.1f} {1:.1f}V{2:.1f}M{3:.1f} {1:.1f}h6M{3:.1f} {2:.1f}h6\"/>\n", x, low, high,
      x - 3);
}

/// The level bar, within the frame.
void put_level_bar(std::string& out, const canvas& c, const plot_point& p) {
  if (!p.left || !p.right || (c.content.log_x && !(*p.right > 0))) return;
  const double left = c.content.log_x && !(*p.left > 0) ? c.left : std::max(c.left, c.x(*p.left));
  const double right = std::min(canvas::right, c.x(*p.right)), y = c.y(c.magnitude(p.y));
  if (right - left < 2) return;  // hidden by the marker
  put(out, "<path class=\"bar\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>\n", left, y, right);
}

/// Through the points on the front, from the cheapest on: no point lies below and left of these stairs.
void put_front(std::string& out, const canvas& c) {
  if (!c.content.front) return;
  std::vector<plot_point> on;
  for (const auto& s : c.content.series)
    for (const auto& p : s.points)
      if (p.fitted && c.drawable(p)) on.push_back(p);
  if (on.empty()) return;
  std::ranges::sort(on, {}, &plot_point::x);
  put(out, "<path class=\"level\" fill=\"none\" d=\"M{:.1f} {:.1f}V{:.1f}", c.x(on[0].x), canvas::top,
      c.y(c.magnitude(on[0].y)));
  for (const auto& p : on) put(out, "H{:.1f}V{:.1f}", c.x(p.x), c.y(c.magnitude(p.y)));
  put(out, "H{:.1f}\"/>\n", canvas::right);
}

void put_power(std::string& out, const canvas& c, const plot_series& s) {
  double first = 0, last = 0;
  for (const auto& p : s.points) {
    if (!p.fitted || !c.drawable(p)) continue;
    if (first == 0) first = p.x;
    last = p.x;
  }
  if (!(first > 0) || !(last > first)) return;
  // A straight line where both axes are logarithmic, a curve otherwise.
  const int pieces = c.content.log_x && c.content.log_y ? 1 : 32;
  out += "<path class=\"line\" d=\"";
  for (int i = 0; i <= pieces; ++i) {
    const double x = first * std::pow(last / first, static_cast<double>(i) / pieces);
    put(out, "{}{:.1f} {:.1f}", i == 0 ? 'M' : 'L', c.x(x), c.y(s.fitted->prefactor * std::pow(x, s.fitted->order)));
  }
  out += "\"/>\n";
}

void put_line(std::string& out, const canvas& c, const plot_series& s) {
  if (s.fitted && is_fitted(s)) return put_power(out, c, s);
  std::string path;
  for (const auto& p : s.points)
    if (c.drawable(p)) put(path, "{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L', c.x(p.x), c.y(c.magnitude(p.y)));
  if (path.find('L') != std::string::npos) put(out, "<path class=\"line thin\" d=\"{}\"/>\n", path);
}

void put_points(std::string& out, const canvas& c, const plot_series& s) {
  const bool fitted = is_fitted(s);
  const auto name = escape_html(s.name);
  for (const auto& p : s.points) {
    if (!c.drawable(p)) continue;
    put_bar(out, c, p);
    put_level_bar(out, c, p);
    const bool hollow = (fitted || c.content.front) && !p.fitted;
    put_marker(out, s, c.x(p.x), c.y(c.magnitude(p.y)), hollow);
    put(out, "><title>{} at {}: {} {}{}</title></path>\n", name, shown(p.x), shown(p.y), shown_interval(p.low, p.high),
        c.content.front ? (hollow ? "" : ", on the front")
        : hollow        ? ", not in the fit"
                        : "");
  }
}

// The legend stands below the plot, in as many columns as the longest name leaves room for.
struct legend {
  std::size_t columns = 1, rows = 1;
  double column_width = canvas::width;

  explicit legend(const plot& p) {
    std::size_t longest = 6;
    for (const auto& s : p.series) longest = std::max(longest, std::min(s.name.size(), longest_name));
    for (const auto& l : p.levels) longest = std::max(longest, std::min(l.name.size(), longest_name));
    const std::size_t entries = p.series.size() + p.levels.size();
    const double wanted = 40 + 8 * static_cast<double>(longest);
    columns = std::clamp<std::size_t>(static_cast<std::size_t>((canvas::width - 10) / wanted), 1, 4);
    rows = std::max<std::size_t>(1, (entries + columns - 1) / columns);
    columns = std::max<std::size_t>(1, (entries + rows - 1) / rows);
    column_width = (canvas::width - 10) / static_cast<double>(columns);
  }
  double height() const { return legend_row * static_cast<double>(rows); }

  // What stands left of the name is drawn by the caller, 22 wide, from (x, y) on.
  template <class Sample>
  void put_entry(std::string& out, const std::string& name, std::size_t index, Sample sample) const {
    const std::size_t column = index / rows, row = index % rows;
    const double x = 10 + column_width * static_cast<double>(column);
    const double y = legend_top + legend_row * static_cast<double>(row);
    sample(x, y);
    put(out, "<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x + 28, y + 4.5,
        escape_html(shortened(name, longest_name)));
  }
};

void put_series(std::string& out, const canvas& c, const legend& key, std::size_t index) {
  const auto& s = c.content.series[index];
  put(out, "<g class=\"series c{}\">\n", s.style % colours);
  put_line(out, c, s);
  put_points(out, c, s);
  key.put_entry(out, s.name, index, [&](double x, double y) {
    put(out, "<path class=\"line\" d=\"M{:.1f} {:.1f}h22\"/>", x, y);
    put_marker(out, s, x + 11, y, false);
    out += "/>";
  });
  out += "</g>\n";
}

void put_level_names(std::string& out, const canvas& c, const legend& key) {
  std::size_t index = c.content.series.size();
  for (const auto& level : c.content.levels)
    key.put_entry(out, level.name, index++,
                  [&](double x, double y) { put(out, "<path class=\"level\" d=\"M{:.1f} {:.1f}h22\"/>", x, y); });
}

// What a reader could not guess: hollow markers, dashed lines, zeros that a logarithm cannot show.
std::string remarks(const canvas& c) {
  std::string text;
  std::size_t zeros = 0;
  bool hollow = false;
  for (const auto& s : c.content.series) {
    const bool fitted = is_fitted(s);
    for (const auto& p : s.points) {
      zeros += c.drawable(p) ? 0 : 1;
      hollow = hollow || (fitted && !p.fitted);
    }
  }
  const auto add = [&](const std::string& remark) { text += (text.empty() ? "" : " · ") + remark; };
  if (c.content.front)
    add("filled, dashed line: the Pareto front");
  else if (hollow)
    add("hollow: not in the fit");
  if (!c.content.slopes.empty()) add("dashed: claimed slope");
  if (zeros > 0) add(fmt::format("{} zero{} not shown", zeros, zeros == 1 ? "" : "s"));
  return text;
}

}  // namespace

std::string to_svg(const plot& p, svg_use use) {
  const canvas c(p);
  const legend key(p);
  const std::string remark = remarks(c);
  const double height = legend_top + key.height() + (remark.empty() ? -6 : 14);
  std::string out;
  put_svg_head(out, p.title, height, use);
  put_axes(out, c);
  put_guides(out, c);
  put_front(out, c);
  out += "<g class=\"all\">\n";
  for (std::size_t i = 0; i < p.series.size(); ++i) put_series(out, c, key, i);
  out += "</g>\n";
  put_level_names(out, c, key);
  if (!remark.empty()) put(out, "<text class=\"soft small\" x=\"10\" y=\"{:.1f}\">{}</text>\n", height - 6, remark);
  return out + "</svg>\n";
}

}  // namespace polhode::report
