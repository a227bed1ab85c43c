// SPDX-License-Identifier: Apache-2.0
#include "statistics/orders/log_line.hpp"

#include <cmath>

#include "statistics/distributions.hpp"

namespace polhode {

log_line line_through(std::span<const log_level> levels) {
  double w = 0, mx = 0, my = 0, sxx = 0, sxy = 0;
  for (const auto& l : levels) {
    w += l.weight();
    mx += l.weight() * l.x;
    my += l.weight() * l.y;
  }
  mx /= w;
  my /= w;
  for (const auto& l : levels) {
    sxx += l.weight() * (l.x - mx) * (l.x - mx);
    sxy += l.weight() * (l.x - mx) * (l.y - my);
  }
  return {my - sxy / sxx * mx, sxy / sxx};
}

double off_the_others(std::span<const log_level> levels) {
  return levels.front().y - line_through(levels.subspan(1)).at(levels.front().x);
}

double slope_at_the_finest(std::span<const log_level> levels) {
  const auto &last = levels.back(), &before = levels[levels.size() - 2];
  return (last.y - before.y) / (last.x - before.x);
}

double half_width_of_scatter(std::span<const log_level> levels, const log_line& line) {
  const auto n = static_cast<double>(levels.size());
  double residual = 0, mean = 0, sxx = 0;
  for (const auto& l : levels) mean += l.x / n;
  for (const auto& l : levels) {
    residual += std::pow(l.y - line.at(l.x), 2);
    sxx += std::pow(l.x - mean, 2);
  }
  return student_t_quantile(0.975, n - 2) * std::sqrt(residual / (n - 2) / sxx);
}

}  // namespace polhode
