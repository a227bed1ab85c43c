// SPDX-License-Identifier: Apache-2.0
#include "statistics/box_dimension.hpp"

#include <algorithm>
#include <cmath>

#include "statistics/orders/log_line.hpp"

namespace polhode {
namespace {

constexpr std::ptrdiff_t least_levels = 3;

box_level level_of(const std::vector<std::uint32_t>& counts, int side) {
  double points = 0, occupied = 0, entropy = 0, pairs = 0;
  for (const double n : counts) points += n;
  for (const double n : counts) {
    if (n == 0) continue;
    ++occupied;
    entropy -= n / points * std::log(n / points);
    pairs += n / points * (n - 1) / (points - 1);
  }
  return {side, points / occupied, {occupied, std::exp(entropy + (occupied - 1) / (2 * points)), 1 / pairs}};
}

/// Boxes of twice the side.
std::vector<std::uint32_t> merged(const std::vector<std::uint32_t>& fine, int charts, int side) {
  const auto n = static_cast<std::size_t>(side), half = n / 2;
  std::vector<std::uint32_t> out(fine.size() / 4);
  for (std::size_t row = 0; row < static_cast<std::size_t>(charts) * n; ++row)
    for (std::size_t column = 0; column < n; ++column) out[row / 2 * half + column / 2] += fine[row * n + column];
  return out;
}

/// log(boxes of that kind) against log(side).
log_line line_of(const std::vector<box_level>& cloud, box_kind kind, const std::vector<bool>& usable) {
  std::vector<log_level> levels;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (usable[i])
      levels.push_back(
          {static_cast<int>(i), std::log(cloud[i].side), std::log(cloud[i].boxes[static_cast<std::size_t>(kind)]), 0});
  return line_through(levels);
}

}  // namespace

std::vector<box_level> count_boxes(std::span<const std::uint32_t> counts, int charts, int side, int least) {
  std::vector<std::uint32_t> boxes(counts.begin(), counts.end());
  std::vector<box_level> levels{level_of(boxes, side)};
  for (; side > least; side /= 2) {
    boxes = merged(boxes, charts, side);
    levels.push_back(level_of(boxes, side / 2));
  }
  std::ranges::reverse(levels);
  return levels;
}

int finest_side(double points, double dimension) {
  return static_cast<int>(std::exp2(std::floor(std::log2(points / least_fill / box_prefactor) / dimension)));
}

std::vector<bool> usable_levels(std::span<const std::vector<box_level>> clouds, int finest) {
  std::vector<bool> usable(clouds.front().size());
  for (std::size_t i = 0; i < usable.size(); ++i) {
    double points = 0, occupied = 0;
    for (const auto& cloud : clouds) {
      points += cloud[i].fill * cloud[i].boxes[0];
      occupied += cloud[i].boxes[0];
    }
    usable[i] = clouds.front()[i].side <= finest && points >= least_fill * occupied;
  }
  return usable;
}

std::optional<dimension_estimate> fit_dimension(std::span<const std::vector<box_level>> clouds, box_kind kind,
                                                const std::vector<bool>& usable) {
  if (std::ranges::count(usable, true) < least_levels) return std::nullopt;
  std::vector<double> slopes;
  double intercept = 0;
  for (const auto& cloud : clouds) {
    const auto line = line_of(cloud, kind, usable);
    slopes.push_back(line.slope);
    intercept += line.intercept / static_cast<double>(clouds.size());
  }
  return dimension_estimate{mean_interval(slopes), std::exp(intercept)};
}

}  // namespace polhode
