// SPDX-License-Identifier: Apache-2.0
#include "statistics/orders/squared_errors.hpp"

#include <algorithm>
#include <cmath>

namespace polhode {

mean_and_error level_mean(const squared_errors& e, int level) {
  double mean = 0, square = 0;
  for (int path = 0; path < e.paths; ++path) mean += e.at(path, level) / e.paths;
  for (int path = 0; path < e.paths; ++path) square += std::pow(e.at(path, level) - mean, 2);
  return {mean, std::sqrt(square / e.paths / std::max(1, e.paths - 1))};
}

squared_errors raised(const squared_errors& e, double p) {
  squared_errors out{e.paths, e.levels, std::vector<double>(static_cast<std::size_t>(e.paths * e.levels))};
  for (std::size_t i = 0; i < out.values.size(); ++i)
    out.values[i] = p == 2   ? e.values[i]
                    : p == 4 ? e.values[i] * e.values[i]
                    : p == 1 ? std::sqrt(e.values[i])
                             : std::pow(e.values[i], p / 2);
  return out;
}

mean_and_error level_norm(const squared_errors& e, double p, int level) {
  squared_errors one{e.paths, 1, {}};
  for (int path = 0; path < e.paths; ++path) one.values.push_back(e.at(path, level));
  const auto m = level_mean(raised(one, p), 0);
  const double norm = std::pow(m.mean, 1 / p);
  return {norm, m.mean > 0 ? norm * m.error / m.mean / p : 0};
}

}  // namespace polhode
