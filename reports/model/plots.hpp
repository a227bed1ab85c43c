// SPDX-License-Identifier: Apache-2.0
// What there is to see of a result: plots and short tables, as plain values that the page and every writer read.
// A description holds no measurement: its lines name the series from which a reader takes them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/model/results.hpp"

namespace polhode::report {

enum class plot_kind {
  curve,       ///< values over a coordinate, a line a series
  front,       ///< cost over error
  reach,       ///< cost over the accuracy that it buys; the lines of a scheme are one point each
  comparison,  ///< one value a scheme
  matrix,      ///< schemes x conditions
  map,         ///< cells over two coordinates, a panel a series
  facts,       ///< numbers that are known of the scene
  conditions   ///< conditions x quantities, known without a scheme
};
constexpr std::string_view name_of(plot_kind kind) {
  constexpr std::array<std::string_view, 8> names{"curve",  "front", "reach", "comparison",
                                                  "matrix", "map",   "facts", "conditions"};
  return names[static_cast<std::size_t>(kind)];
}

/// A measurement belongs to a line if it is of the series and has the coordinates that are the axes of the plot.
struct plot_line {
  series_id series;                      ///< the values; of the experiment of the plot, as all of its series
  std::optional<series_id> across = {};  ///< of `front`: the errors; cost and error pair by their step size
  std::vector<series_id> beside = {};    ///< told with the point of the same abscissa
  std::optional<series_id> border = {};  ///< of `map`: measured at one of its coordinates
};

/// The same points over another ordinate.
struct plot_alternative {
  std::string name, title, y_title;
  std::vector<plot_line> lines;
};

/// Texts are as written in results: "lambda_1 over theta [per time]".
struct plot_description {
  std::string id;  ///< unique, of a-z, 0-9, dots and hyphens
  std::string experiment;
  plot_kind kind = plot_kind::curve;
  std::string title, note = {};
  std::string of = {};                                    ///< of `front` and `reach`: which error
  std::string x = {}, y = {};                             ///< the coordinates that are its axes
  std::vector<std::string> conditions = {};               ///< the coordinates that name a condition
  std::string x_title = {}, y_title = {};                 ///< of the axes
  std::string value_title = {}, border_title = {};        ///< of `map` and `matrix`
  bool log_x = false, log_y = false, log_values = false;  ///< of `matrix`: the colours
  std::string absolute_title = {};                        ///< there is y < 0: a logarithm shows |y|
  bool diverging = false;                                 ///< of `map`: colours by sign, else by share
  bool border_across = false;                             ///< the border gives an x for each y, else a y
  std::string hollow = {};                                ///< what a point says that was not used
  std::vector<double> slopes = {};                        ///< claimed orders, for comparison
  std::optional<double> claimed = {};                     ///< of `comparison`: by all of its schemes
  std::vector<plot_line> lines = {};                      ///< in the order of the schemes
  std::vector<series_id> levels = {};                     ///< values that belong to no abscissa
  std::vector<plot_alternative> others = {};
};

}  // namespace polhode::report
