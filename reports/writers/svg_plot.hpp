// A plot as SVG text from plain values. It measures nothing and knows nothing of schemes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode::report {

struct plot_point {
  double x = 0, y = 0;
  std::optional<double> low, high;  ///< drawn as an error bar
  bool fitted = false;              ///< hollow where its series was fitted without it, or where it is not on the front
  std::optional<double> left = {}, right = {};  ///< drawn as a level error bar
};

/// y = prefactor * x^order
struct plot_power {
  double order = 0, prefactor = 0;
};

struct plot_series {
  std::string name;
  std::vector<plot_point> points;    ///< by rising x
  std::optional<plot_power> fitted;  ///< drawn over the fitted points, in place of a line through them
  std::size_t style = 0;             ///< colour and marker; the same number looks the same in every plot
};

/// A horizontal line.
struct plot_level {
  std::string name;
  double y = 0;
};

struct plot {
  std::string title, x_title, y_title;
  bool log_x = true, log_y = true;  ///< a logarithmic ordinate shows |y|, and says how many zeros it left out
  std::vector<plot_series> series;
  std::vector<double> slopes;  ///< reference slopes, dashed
  std::vector<plot_level> levels;
  bool front = false;  ///< points say whether they are on the Pareto front, which is drawn through these
};

enum class svg_use { inside_html, standalone };

std::string to_svg(const plot&, svg_use = svg_use::standalone);

/// The style sheet of all plots (light, dark, print); a page with plots inside needs it once.
std::string_view plot_style();

}  // namespace polhode::report
