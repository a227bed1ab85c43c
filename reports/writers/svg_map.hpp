// A map as SVG text: values over two coordinates as colours, curves over them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/writers/svg_plot.hpp"

namespace polhode::report {

struct map_cell {
  double x = 0, y = 0;
  std::optional<double> value;  ///< grey where there is none
  std::string status;           ///< why
};

struct map_curve {
  std::string name;
  std::vector<plot_point> points;  ///< by rising x
};

struct value_map {
  std::string title, x_title, y_title, value_title;
  bool log_x = false, log_y = false;
  std::vector<map_cell> cells;  ///< each reaches half way to the next
  std::vector<map_curve> curves;
};

/// White at zero, blue above, orange below: every kind of colour vision tells them apart. The depth of the colour goes
/// with the root of the value, so that the smaller sign shows too; the scale beside says so.
std::string to_svg(const value_map&, svg_use = svg_use::standalone);

}  // namespace polhode::report
