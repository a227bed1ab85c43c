// The part of a plot that is there before any series: frame, ticks, titles, reference lines.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>

#include "reports/writers/svg_axis.hpp"
#include "reports/writers/svg_plot.hpp"

namespace polhode::report {

inline constexpr std::size_t longest_name = 26;

template <class... Values>
void put(std::string& out, fmt::format_string<Values...> text, Values&&... values) {
  fmt::format_to(std::back_inserter(out), text, std::forward<Values>(values)...);
}

/// Where everything stands. On a logarithmic ordinate |y| is what is drawn.
struct canvas {
  static constexpr double width = 440, top = 12, bottom = 302, right = 426;
  const plot& content;
  axis x, y;
  double left = 0;

  explicit canvas(const plot&);
  double magnitude(double value) const { return content.log_y ? std::abs(value) : value; }
  bool drawable(const plot_point& p) const {
    return std::isfinite(p.x) && std::isfinite(p.y) && (!content.log_y || p.y != 0) && (!content.log_x || p.x > 0);
  }
};

void put_axes(std::string& out, const canvas&);
/// Dashed lines: the reference slopes, fanned out from above the greatest value, and the horizontal levels.
void put_guides(std::string& out, const canvas&);

}  // namespace polhode::report
