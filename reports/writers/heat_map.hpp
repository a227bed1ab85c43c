// A map over two logarithmic axes as SVG text, with a border drawn into it. It measures nothing.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode::report {

struct heat_cell {
  double x = 0, y = 0;  ///< > 0
  double value = 0;     ///< 0 … 1: dark … light
  std::string remark;   ///< why the value is not the whole story: such a cell is crossed
};

/// Between low and high at this y; without low everything lies beyond the border, without high nothing does.
struct border_point {
  double y = 0;
  std::optional<double> low, high;
  std::string remark;
};

struct heat_map {
  std::string title, x_title, y_title;
  std::vector<heat_cell> cells;
  std::vector<border_point> border;   ///< by rising y
  std::vector<double> columns, rows;  ///< all x and y of the axes, increasing; a place without a cell stays empty
};

std::string to_svg(const heat_map&);

/// Its style sheet, besides that of plots; a page needs it once.
std::string_view heat_map_style();

}  // namespace polhode::report
