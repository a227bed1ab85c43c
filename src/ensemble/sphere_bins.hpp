// Equal-area bins on the sphere of directions: what a snapshot counts in.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace polhode {

/// Longitude from -pi and z from -1, rows of equal z: every bin has the same area. What is written to files.
struct longitude_bins {
  static constexpr int longitudes = 1024, heights = 512;
  static constexpr std::size_t count = std::size_t{longitudes} * heights;

  static std::size_t of(double x, double y, double z) {
    const double turn = std::atan2(y, x) / (2 * std::numbers::pi) + 0.5;
    const int column = std::min(static_cast<int>(turn * longitudes), longitudes - 1);
    const int row = std::min(static_cast<int>(0.5 * (z + 1) * heights), heights - 1);
    return static_cast<std::size_t>(row) * longitudes + static_cast<std::size_t>(column);
  }
};

/// The hemispheres z >= 0 and z < 0 in Lambert's azimuthal equal-area projection, each in a square of side^2 bins.
/// Pictures are drawn from these: bins in longitude and z are slivers at the poles, where the bodies like to be.
struct hemisphere_bins {
  static constexpr int side = 512;
  static constexpr std::size_t count = std::size_t{2} * side * side;

  static std::size_t of(double x, double y, double z) {
    const double scale = 0.5 / std::sqrt(1 + std::abs(z));
    const auto cell = [&](double u) { return std::clamp(static_cast<int>((u * scale + 0.5) * side), 0, side - 1); };
    const std::size_t half = z < 0 ? 1 : 0;
    return (half * side + static_cast<std::size_t>(cell(y))) * side + static_cast<std::size_t>(cell(x));
  }
};

}  // namespace polhode
