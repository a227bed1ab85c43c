// SPDX-License-Identifier: Apache-2.0
#include "transfer/points/half_turns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "ensemble/kernel.hpp"

namespace polhode {
namespace {

constexpr double rounding = 1e-13;  // of a vector
constexpr int most_channels = 4;

double sign_of(unsigned flipped, std::size_t channel) { return (flipped >> channel & 1) == 0 ? 1 : -1; }

/// The same nodes with the signs of those channels changed; an area has the signs of both of its channels.
noise_nodes with_signs(noise_nodes nodes, unsigned flipped) {
  const auto count = nodes.weight.size(), channels = nodes.dw.size() / count, pairs = nodes.area.size() / count;
  for (std::size_t node = 0; node < count; ++node) {
    for (std::size_t k = 0; k < channels; ++k) nodes.dw[node * channels + k] *= sign_of(flipped, k);
    for (std::size_t i = 0, pair = 0; i < channels; ++i)
      for (std::size_t j = i + 1; j < channels && pair < pairs; ++j, ++pair)
        nodes.area[node * pairs + pair] *= sign_of(flipped, i) * sign_of(flipped, j);
  }
  return nodes;
}

/// The first of the nodes at which most increments and areas are other than 0: there signs can be told.
int telling_node(const noise_nodes& all) {
  constexpr double none = 1e-3;
  const auto count = all.weight.size(), channels = all.dw.size() / count, pairs = all.area.size() / count;
  std::vector<std::ptrdiff_t> size;
  for (std::size_t node = 0; node < count; ++node) {
    const auto larger_than = [](double least) { return [=](double x) { return std::fabs(x) > least; }; };
    size.push_back(std::ranges::count_if(std::span(all.dw).subspan(node * channels, channels),
                                         larger_than(none * std::sqrt(all.dt))) +
                   std::ranges::count_if(std::span(all.area).subspan(node * pairs, pairs), larger_than(none * all.dt)));
  }
  return static_cast<int>(std::ranges::max_element(size) - size.begin());
}

noise_nodes one_of(const noise_nodes& all, int node) {
  const auto of_node = [&](const std::vector<double>& some) {
    const auto size = static_cast<std::ptrdiff_t>(some.size() / all.weight.size());
    return std::vector<double>(some.begin() + node * size, some.begin() + (node + 1) * size);
  };
  return {all.dt, of_node(all.dw), of_node(all.area), {1.0}};
}

void turn(std::span<double> vectors, const Eigen::Vector3d& signs) {
  for (std::size_t i = 0; i < vectors.size(); ++i) vectors[i] *= signs[static_cast<Eigen::Index>(i / block_lanes % 3)];
}

bool same(std::span<const double> a, std::span<const double> b) {
  constexpr std::size_t row = block_lanes, block = 3 * row;
  bool all = true;
  for (std::size_t first = 0; first < a.size() && all; first += block)
    for (std::size_t i = first; i < first + row; ++i) {  // without a branch: for the compiler's packs
      const double square = a[i] * a[i] + a[i + row] * a[i + row] + a[i + 2 * row] * a[i + 2 * row];
      const double x = a[i] - b[i], y = a[i + row] - b[i + row], z = a[i + 2 * row] - b[i + 2 * row];
      const double most = rounding * rounding * square;
      all &= (x * x <= most) & (y * y <= most) & (z * z <= most);
    }
  return all;
}

}  // namespace

bool commutes_with_half_turns(std::span<const double> vectors, const noise_nodes& nodes, int active,
                              const std::function<block_step(const noise_nodes&)>& make) {
  if (active > most_channels) return false;
  const std::vector<double> start(vectors.begin(), vectors.end());
  const auto step = make(nodes);
  std::vector<double> straight, there, turned;
  const auto advance = [&](int node) {
    straight = start;
    step(node, straight);
  };
  /// Whether what `advance` found, turned, is what another step makes of the turned start.
  const auto commutes = [&](int axis, int node, const block_step& other) {
    const Eigen::Vector3d signs = half_turns.row(axis).transpose();
    there = straight;
    turned = start;
    turn(there, signs);
    turn(turned, signs);
    other(node, turned);
    return same(there, turned);
  };
  constexpr std::array axes{1, 2};  // the third follows
  std::array<block_step, 2> others;
  const int telling = telling_node(nodes);
  const auto one = one_of(nodes, telling);
  advance(telling);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    for (unsigned flipped = 0; flipped < 1u << active && !others[i]; ++flipped)
      if (commutes(axes[i], 0, make(with_signs(one, flipped)))) others[i] = make(with_signs(nodes, flipped));
    if (!others[i]) return false;
  }
  for (int node = 0; node < static_cast<int>(nodes.weight.size()); ++node) {
    advance(node);
    for (std::size_t i = 0; i < axes.size(); ++i)
      if (!commutes(axes[i], node, others[i])) return false;
  }
  return true;
}

}  // namespace polhode
