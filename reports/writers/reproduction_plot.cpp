// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/reproduction_plot.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

#include "reports/writers/numbers.hpp"
#include "reports/writers/text.hpp"

namespace polhode::report {
namespace {

constexpr double plot_width = 440, plot_height = 270, left = 74, right = 14, top = 12, bottom = 42;

/// From numbers to places, along one axis.
struct axis {
  bool logarithmic;
  double low, high, from, to;
  double value_of(double x) const { return logarithmic ? std::log10(x) : x; }
  double at(double x) const { return from + (value_of(x) - low) / (high - low) * (to - from); }
};

axis axis_over(const std::vector<double>& values, bool logarithmic, double from, double to) {
  axis a{logarithmic, HUGE_VAL, -HUGE_VAL, from, to};
  for (const double v : values) {
    a.low = std::min(a.low, a.value_of(v));
    a.high = std::max(a.high, a.value_of(v));
  }
  const double margin = 0.05 * std::max(a.high - a.low, 1e-9);
  a.low -= margin;
  a.high += margin;
  return a;
}

/// Powers of ten, each `every`-th of them; over few of them 2 and 5 times these as well.
std::vector<double> logarithmic_ticks(const axis& a) {
  const int every = std::max(1, static_cast<int>(std::ceil((a.high - a.low) / 5)));
  std::vector<double> out;
  for (int power = static_cast<int>(std::floor(a.low)); power <= a.high; power += every)
    for (const double times : {1.0, 2.0, 5.0}) {
      const double t = times * std::pow(10, power), at = a.value_of(t);
      if (at >= a.low && at <= a.high && (times == 1 || a.high - a.low < 2)) out.push_back(t);
    }
  return out;
}

/// Of a step 1, 2 or 5 times a power of ten.
std::vector<double> ticks_of(const axis& a) {
  if (a.logarithmic) return logarithmic_ticks(a);
  const double rough = (a.high - a.low) / 4, power = std::pow(10, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double s : {5.0, 2.0, 1.0})
    if (s * power >= rough) step = s * power;
  std::vector<double> out;
  const auto last = static_cast<std::int64_t>(std::floor(a.high / step + 1e-9));
  for (auto k = static_cast<std::int64_t>(std::ceil(a.low / step)); k <= last; ++k)
    out.push_back(static_cast<double>(k) * step);
  return out;
}

std::string frame_of(const axis& x, const axis& y, const reproduced_curve& c) {
  std::string out =
      fmt::format("<path class=\"axis\" d=\"M{0} {1}V{2}H{3}\"/>", left, top, plot_height - bottom, plot_width - right);
  for (const double t : ticks_of(x))
    out += fmt::format("<text class=\"tick\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>", x.at(t),
                       plot_height - bottom + 16, shown(t));
  for (const double t : ticks_of(y))
    out += fmt::format(
        "<text class=\"tick\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text><path class=\"grid\" d=\"M{} "
        "{:.1f}H{}\"/>",
        left - 6, y.at(t) + 4, shown(t), left, y.at(t), plot_width - right);
  out += fmt::format("<text class=\"name\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
                     (left + plot_width - right) / 2, plot_height - 6, escape_html(c.x));
  return out +
         fmt::format("<text class=\"name\" transform=\"translate(13 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
                     (top + plot_height - bottom) / 2, escape_html(c.y));
}

bool drawable(const reproduced_curve& c, double v) { return std::isfinite(v) && (!c.logarithmic || v > 0); }

}  // namespace

std::string to_svg(const reproduced_curve& c) {
  std::vector<double> xs, ys;
  for (const auto& p : c.points)
    for (const auto& y : {p.published, p.ours})
      if (y && drawable(c, p.x) && drawable(c, *y)) {
        xs.push_back(p.x);
        ys.push_back(*y);
      }
  if (xs.size() < 2) return "";
  const auto x = axis_over(xs, c.logarithmic, left, plot_width - right),
             y = axis_over(ys, c.logarithmic, plot_height - bottom, top);
  std::string line, circles;
  for (const auto& p : c.points) {
    if (!drawable(c, p.x)) continue;
    if (p.published && drawable(c, *p.published))
      line += fmt::format("{}{:.1f} {:.1f}", line.empty() ? "M" : "L", x.at(p.x), y.at(*p.published));
    if (p.ours && drawable(c, *p.ours))
      circles +=
          fmt::format("<circle class=\"ours\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\"><title>{}: {}</title></circle>",
                      x.at(p.x), y.at(*p.ours), shown(p.x), shown(p.ours));
  }
  return fmt::format(
      "<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">{}<path class=\"published\" d=\"{}\"/>{}</svg>",
      plot_width, plot_height, escape_html(c.title), frame_of(x, y, c), line, circles);
}

}  // namespace polhode::report
