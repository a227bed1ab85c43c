// SPDX-License-Identifier: Apache-2.0
#include "experiments/laws/extrapolation.hpp"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

error_table without(const error_table& t, int power) {
  const double two_p = std::exp2(power);
  error_table out{t.scheme, {}, {}, {}};
  for (std::size_t i = 0; i + 1 < t.dt.size(); ++i) {
    if (std::fabs(t.dt[i] - 2 * t.dt[i + 1]) > 1e-12 * t.dt[i]) continue;
    out.dt.push_back(t.dt[i]);
    out.error.emplace_back((two_p * t.error[i + 1] - t.error[i]) / (two_p - 1));
    out.uncertainty.emplace_back((two_p * t.uncertainty[i + 1] + t.uncertainty[i]) / (two_p - 1));
  }
  return out;
}

/// The largest error of a level, in units of the scales.
double worst(const error_table& t, std::span<const error_column> columns, std::size_t level) {
  double out = 0;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    out = std::max(out, (std::fabs(t.error[level][i]) + t.uncertainty[level][i]) / columns[k].scale);
  }
  return out;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> extrapolated_names() {
  std::vector<std::pair<std::string, std::string>> out;
  for (const auto& e : extrapolations) out.emplace_back(e.name, extrapolated_from);
  return out;
}

error_table extrapolate(const error_table& t, const extrapolation& e) {
  error_table out = t;
  for (const int power : e.powers) out = without(out, power);
  out.scheme = e.name;
  return out;
}

double steps_for(const error_table& t, std::span<const error_column> columns, double horizon, double accuracy,
                 double order, double runs) {
  const std::size_t levels = t.dt.size();
  std::size_t i = 0;
  while (i < levels && !(worst(t, columns, i) <= accuracy)) ++i;
  const std::size_t near = std::min(i, levels - 1);
  double slope = order;
  if (i > 0 && i < levels)
    slope = std::log2(worst(t, columns, i - 1) / worst(t, columns, i)) / std::log2(t.dt[i - 1] / t.dt[i]);
  const double dt = t.dt[near] * std::pow(accuracy / worst(t, columns, near), 1 / slope);
  return runs * std::max(1.0, horizon / std::min(dt, horizon));
}

}  // namespace polhode
