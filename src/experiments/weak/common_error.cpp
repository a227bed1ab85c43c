// SPDX-License-Identifier: Apache-2.0
#include "experiments/weak/common_error.hpp"

#include <array>
#include <cmath>

namespace polhode {
namespace {

/// Root mean square of the errors over their standard errors; not a number where one of them is none.
double clearness(const std::vector<squared_errors>& d, int level) {
  double sum = 0;
  for (const auto& f : d) {
    const auto m = level_mean(f, level);
    if (m.error != 0) sum += std::pow(m.mean / m.error, 2) / static_cast<double>(d.size());
  }
  return std::sqrt(sum);
}

int clear_level(const std::vector<squared_errors>& d, double resolved) {
  int best = d.front().levels - 1;
  double most = 0;
  for (int l = best; l >= 0; --l) {
    const double clear = clearness(d, l);
    if (clear >= resolved) return l;
    if (clear > most) {
      most = clear;
      best = l;
    }
  }
  return best;
}

}  // namespace

squared_errors along_their_errors(const std::vector<squared_errors>& differences, std::span<const double> sizes,
                                  double resolved) {
  const auto& shape = differences.front();
  const int level = clear_level(differences, resolved);
  std::array<std::vector<double>, 2> weights;
  for (std::size_t half = 0; half < 2; ++half) {
    double square = 0;
    for (std::size_t f = 0; f < differences.size(); ++f) {
      double mean = 0;
      for (int path = 1 - static_cast<int>(half); path < shape.paths; path += 2) mean += differences[f].at(path, level);
      const double w = sizes[f] > 0 ? mean / sizes[f] : 0;
      weights[half].push_back(sizes[f] > 0 ? w / sizes[f] : 0);
      square += w * w;
    }
    for (double& w : weights[half]) w = square > 0 ? w / std::sqrt(square) : 0;
  }
  squared_errors out{shape.paths, shape.levels,
                     std::vector<double>(static_cast<std::size_t>(shape.paths * shape.levels))};
  for (int path = 0; path < shape.paths; ++path)
    for (int l = 0; l < shape.levels; ++l)
      for (std::size_t f = 0; f < differences.size(); ++f)
        out.at(path, l) += weights[static_cast<std::size_t>(path % 2)][f] * differences[f].at(path, l);
  return out;
}

}  // namespace polhode
