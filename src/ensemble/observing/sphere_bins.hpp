// SPDX-License-Identifier: Apache-2.0
// Equal-area bins on the sphere of directions: what a snapshot counts in. A bin is a whole number in a double, or in a
// pack of them; without contraction of products and sums it is the same for every width.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>

#include <polhode/scalar.hpp>

#include "ensemble/observing/angle.hpp"

namespace polhode {

/// The cell 0 … cells - 1 that holds `place`; what lies outside goes to the first or the last.
template <class S>
S cell_of(const S& place, int cells) {
  using std::floor;
  const S cell = floor(place), last(cells - 1.0);
  return select(cell > last, last, select(cell < S(0.0), S(0.0), cell));
}

/// Longitude from -pi and z from -1, rows of equal z: every bin has the same area. What is written to files.
struct longitude_bins {
  static constexpr int longitudes = 1024, heights = 512;
  static constexpr std::size_t count = std::size_t{longitudes} * heights;

  /// z of unit length; x and y of any.
  template <class S>
  static S of(const S& x, const S& y, const S& z) {
    const S turn = angle_of(y, x) / S(2 * std::numbers::pi) + S(0.5);
    const S row = cell_of(S(S(0.5) * (z + S(1.0)) * S(heights)), heights);
    return row * S(longitudes) + cell_of(S(turn * S(longitudes)), longitudes);
  }
};

/// The hemispheres z >= 0 and z < 0 in Lambert's azimuthal equal-area projection, each in a square of side^2 bins.
/// Pictures are drawn from these: bins in longitude and z are slivers at the poles, where the bodies like to be.
struct hemisphere_bins {
  static constexpr int side = 512;
  static constexpr std::size_t count = std::size_t{2} * side * side;

  /// Of a unit vector.
  template <class S>
  static S of(const S& x, const S& y, const S& z) {
    const S scale = S(0.5) / square_root(S(S(1.0) + magnitude(z)));
    const S column = cell_of(S((x * scale + S(0.5)) * S(side)), side),
            row = cell_of(S((y * scale + S(0.5)) * S(side)), side);
    return (select(z < S(0.0), S(side), S(0.0)) + row) * S(side) + column;
  }
};

}  // namespace polhode
