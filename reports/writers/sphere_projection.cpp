// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/sphere_projection.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polhode::report {
namespace {

constexpr double pi = std::numbers::pi;

/// The bins of a snapshot: Lambert's equal-area projection of each hemisphere, as ensemble_snapshot::picture says.
struct lambert {
  int side;
  static double scale_at(double z) { return 0.5 / std::sqrt(1 + std::abs(z)); }
  int cell(double u) const { return std::clamp(static_cast<int>((u + 0.5) * side), 0, side - 1); }
  /// Of x and y already scaled.
  std::uint32_t bin(double x, double y, bool below) const {
    return static_cast<std::uint32_t>(((below ? side : 0) + cell(y)) * side + cell(x));
  }
};

}  // namespace

// A row is a circle of latitude, run through by a rotation. Source: Snyder, Map Projections (1987), eqs. (31-6) to
// (31-8).
void mollweide_row(int side, double y, sample_row& out) {
  const lambert bins{side};
  const double a = std::asin(y), w = 0.5 * static_cast<double>(out.size()), half = std::cos(a);
  const double z = std::clamp((2 * a + std::sin(2 * a)) / pi, -1.0, 1.0);
  const double r = std::sqrt(1 - z * z) * lambert::scale_at(z);
  const auto first = static_cast<std::size_t>(std::max(0.0, std::ceil(w * (1 - half) - 0.5)));
  const double start = pi * ((static_cast<double>(first) + 0.5) / w - 1) / half, step = pi / (w * half);
  const double cos = std::cos(step), sin = std::sin(step);
  double east = r * std::cos(start), north = r * std::sin(start);
  std::ranges::fill(out, outside);
  for (std::size_t k = first; k + first < out.size(); ++k) {
    out[k] = bins.bin(east, north, z < 0);
    const double turned = east * cos - north * sin;
    north = north * cos + east * sin;
    east = turned;
  }
}

void upper_row(int side, double y, sample_row& out) {
  const lambert bins{side};
  const double w = 0.5 * static_cast<double>(out.size());
  for (std::size_t k = 0; k < out.size(); ++k) {
    const double x = (static_cast<double>(k) + 0.5) / w - 1, z2 = 1 - x * x - y * y;
    const double scale = lambert::scale_at(std::sqrt(std::max(0.0, z2)));
    out[k] = z2 > 0 ? bins.bin(x * scale, y * scale, false) : outside;
  }
}

// Seen from below x runs to the left.
void lower_row(int side, double y, sample_row& out) {
  upper_row(side, y, out);
  std::ranges::reverse(out);
  for (auto& bin : out)
    if (bin != outside) bin += static_cast<std::uint32_t>(side * side);
}

}  // namespace polhode::report
