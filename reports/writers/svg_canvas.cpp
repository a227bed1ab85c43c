#include "reports/writers/svg_canvas.hpp"

#include <algorithm>
#include <vector>

#include "reports/writers/numbers.hpp"
#include "reports/writers/text.hpp"

namespace polhode::report {
namespace {

std::vector<double> abscissas(const plot& p) {
  std::vector<double> values;
  for (const auto& s : p.series)
    for (const auto& point : s.points) values.push_back(point.x);
  return values;
}

// Error bars count too, but one that reaches down to nothing does not flatten the picture.
std::vector<double> ordinates(const plot& p) {
  std::vector<double> values;
  double most = 0;
  for (const auto& s : p.series)
    for (const auto& point : s.points) {
      const double y = p.log_y ? std::abs(point.y) : point.y;
      values.push_back(y);
      most = std::max(most, y);
      for (const auto& end : {point.low, point.high}) {
        if (!end) continue;
        const double bar = p.log_y ? std::abs(*end) : *end;
        if (!p.log_y || (bar > y / 30 && bar < y * 30)) values.push_back(bar);
      }
    }
  if (p.log_y && !p.slopes.empty()) values.push_back(1.6 * most);
  for (const auto& level : p.levels) values.push_back(p.log_y ? std::abs(level.y) : level.y);
  return values;
}

std::size_t letters(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char b) { return (b & 0xC0) != 0x80; }));
}

// The part of the fan that is inside the frame; a label rides on each line where it comes in.
void put_slopes(std::string& out, const canvas& c) {
  const double top = c.y.most() - 0.03 * (c.y.most() - c.y.least());
  for (const double slope : c.content.slopes) {
    if (slope < 0) continue;  // falls to the right of the fan's origin: outside
    double start = c.x.least();
    if (slope > 0) start = std::max(start, c.x.most() - (top - c.y.least()) / slope);
    const double level = top - slope * (c.x.most() - start);
    const double x = c.x.at_internal(start), y = c.y.at_internal(level), end = c.y.at_internal(top);
    put(out, "<path class=\"guide\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>\n", x, y, c.right, end);
    const double degrees = std::atan2(end - y, c.right - x) * 57.29577951308232;
    put(out,
        "<text class=\"soft small halo\" transform=\"translate({:.1f} {:.1f}) rotate({:.1f})\" x=\"12\" y=\"-5\">slope "
        "{}</text>\n",
        x, y, degrees, shown(slope));
  }
}

void put_levels(std::string& out, const canvas& c) {
  for (const auto& level : c.content.levels) {
    if (!std::isfinite(level.y) || (c.content.log_y && level.y == 0)) continue;
    const double y = c.y(c.magnitude(level.y));
    put(out, "<path class=\"level\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>\n", c.left, y, c.right);
  }
}

}  // namespace

void put_svg_head(std::string& out, const std::string& title, double height, svg_use use) {
  put(out, "<svg {}class=\"plot\" viewBox=\"0 0 {} {:.0f}\" role=\"img\" aria-label=\"{}\">\n",
      use == svg_use::standalone ? "xmlns=\"http://www.w3.org/2000/svg\" " : "", frame::width, height,
      escape_html(title));
  if (use == svg_use::standalone)
    put(out, "<style>{}</style>\n<rect class=\"paper\" width=\"100%\" height=\"100%\"/>\n", plot_style());
}

void put_paper(std::string& out, const frame& f) {
  put(out, "<rect class=\"paper\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n", f.left, f.top,
      f.right - f.left, f.bottom - f.top);
}

void put_ticks(std::string& out, const frame& f, const axis& x, const axis& y, bool grid) {
  for (const auto& t : x.ticks()) {
    if (t.major && grid) put(out, "<path class=\"grid\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>\n", t.place, f.top, f.bottom);
    put(out, "<path class=\"tick\" d=\"M{:.1f} {:.1f}v{}\"/>\n", t.place, f.bottom, t.label.empty() ? 3 : 5);
    if (!t.label.empty())
      put(out, "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n", t.place, f.bottom + 18, t.label);
  }
  for (const auto& t : y.ticks()) {
    if (t.major && grid) put(out, "<path class=\"grid\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>\n", f.left, t.place, f.right);
    put(out, "<path class=\"tick\" d=\"M{:.1f} {:.1f}h-{}\"/>\n", f.left, t.place, t.label.empty() ? 3 : 5);
    if (!t.label.empty())
      put(out, "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n", f.left - 8, t.place + 4.5, t.label);
  }
}

void put_frame(std::string& out, const frame& f, const std::string& x_title, const std::string& y_title) {
  put(out, "<rect class=\"frame\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n", f.left, f.top,
      f.right - f.left, f.bottom - f.top);
  put(out, "<text class=\"soft\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n", (f.left + f.right) / 2,
      f.bottom + 38, escape_html(shortened(x_title, 50)));
  put(out, "<text class=\"soft\" transform=\"translate(13 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
      (f.top + f.bottom) / 2, escape_html(shortened(y_title, 40)));
}

frame place_in_frame(axis& x, axis& y) {
  frame f;
  y.place_between(f.bottom, f.top);
  std::size_t longest = 0;
  for (const auto& t : y.ticks()) longest = std::max(longest, letters(t.label));
  f.left = 34 + 7.2 * static_cast<double>(std::min<std::size_t>(longest, 14));
  x.place_between(f.left, f.right);
  return f;
}

canvas::canvas(const plot& p) : content(p), x(p.log_x, abscissas(p)), y(p.log_y, ordinates(p)) {
  static_cast<frame&>(*this) = place_in_frame(x, y);
}

void put_axes(std::string& out, const canvas& c) {
  put_paper(out, c);
  put_ticks(out, c, c.x, c.y, true);
  put_frame(out, c, c.content.x_title, c.content.y_title);
}

void put_guides(std::string& out, const canvas& c) {
  if (c.content.log_x && c.content.log_y) put_slopes(out, c);
  put_levels(out, c);
}

}  // namespace polhode::report
