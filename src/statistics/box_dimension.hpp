// SPDX-License-Identifier: Apache-2.0
// Dimensions of a cloud of points from how full equal-area boxes of several sizes are. With p_i the share of the points
// in box i and e the side of the boxes, as e falls
//
//   N(e) ~ e^-D0 occupied boxes,   exp(-sum p_i log p_i) ~ e^-D1,   1 / sum p_i^2 ~ e^-D2,   D2 <= D1 <= D0
//
// (Renyi; Grassberger and Procaccia, Physica D 9 (1983) 189). The three left sides are numbers of boxes: all of them,
// those that hold the information, those that hold the pairs.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "statistics/sample.hpp"

namespace polhode {

enum class box_kind : std::uint8_t { occupied, information, pairs };
inline constexpr std::array box_kinds{box_kind::occupied, box_kind::information, box_kind::pairs};

/// One size of boxes, a power of two a side.
struct box_level {
  int side = 0;                   ///< boxes along the side of a chart: e is proportional to 1/side
  double fill = 0;                ///< points an occupied box
  std::array<double, 3> boxes{};  ///< [box_kind]
};

/// From counts [chart][row][column] in charts of side^2 boxes, side a power of two; boxes are merged two by two down to
/// `least` a side. Coarsest level first. A finite sample sees too few boxes: the number of pairs is free of that bias
/// (pairs of different points), the entropy has its first order, (occupied - 1) / (2 points), added (Miller and Madow),
/// the number of occupied boxes has nothing and is too small.
std::vector<box_level> count_boxes(std::span<const std::uint32_t> counts, int charts, int side, int least);

/// Slopes of log(boxes) over log(side), one cloud after the other, and their mean.
struct dimension_estimate {
  interval_estimate value;  ///< Student's 95 % interval over the clouds
  double boxes_at_one = 0;  ///< of the mean line: boxes = boxes_at_one side^value
};

inline constexpr double least_fill = 16;    ///< points an occupied box, over all clouds
inline constexpr double box_prefactor = 7;  ///< of boxes against side^dimension on a sphere: the paper's are 5.4 to 6.6

/// Boxes a side of the finest level to count, fixed before a cloud is seen, lest the choice follow chance that the
/// interval does not know of: the largest power of two at which `points` fill box_prefactor side^dimension boxes.
int finest_side(double points, double dimension);

/// Which levels count: those up to `finest` on which an occupied box holds at least `least_fill` points. Fewer than
/// three: nothing can be said.
std::vector<bool> usable_levels(std::span<const std::vector<box_level>> clouds, int finest);

/// At least two clouds with the same levels; nothing where fewer than three levels are usable.
std::optional<dimension_estimate> fit_dimension(std::span<const std::vector<box_level>> clouds, box_kind,
                                                const std::vector<bool>& usable);

}  // namespace polhode
