// SPDX-License-Identifier: Apache-2.0
// A plot as plain values, ready to be drawn. It measures nothing and knows nothing of schemes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace polhode::report {

struct plot_point {
  double x = 0, y = 0;
  std::optional<double> low, high;  ///< drawn as an error bar
  bool fitted = false;              ///< its series was fitted with it
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

struct plot {
  std::string title, x_title, y_title;
  bool log_x = true, log_y = true;  ///< a logarithmic ordinate shows |y|, and leaves out zeros
  std::vector<plot_series> series;
};

}  // namespace polhode::report
