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

/// The field between the axes, the same in every picture but for its left, which leaves room for labels.
struct frame {
  static constexpr double width = 440, top = 12, bottom = 302, right = 426;
  double left = 0;
};

/// Places both axes; the labels of the ordinate decide the left.
frame place_in_frame(axis& x, axis& y);

void put_svg_head(std::string& out, const std::string& title, double height, svg_use);
void put_paper(std::string& out, const frame&);
void put_ticks(std::string& out, const frame&, const axis& x, const axis& y, bool grid);
void put_frame(std::string& out, const frame&, const std::string& x_title, const std::string& y_title);

/// Where everything stands. On a logarithmic ordinate |y| is what is drawn.
struct canvas : frame {
  const plot& content;
  axis x, y;

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
