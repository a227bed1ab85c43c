#include "experiments/half_turns.hpp"

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

void turn(std::span<double> vectors, const Eigen::Vector3d& signs) {
  for (std::size_t i = 0; i < vectors.size(); ++i) vectors[i] *= signs[static_cast<Eigen::Index>(i / block_lanes % 3)];
}

bool same(std::span<const double> a, std::span<const double> b) {
  constexpr std::size_t block = 3 * block_lanes;
  for (std::size_t first = 0; first < a.size(); first += block)
    for (std::size_t lane = first; lane < first + block_lanes; ++lane) {
      const auto length = std::hypot(a[lane], a[lane + block_lanes], a[lane + 2 * block_lanes]);
      for (std::size_t i = lane; i < first + block; i += block_lanes)
        if (!(std::fabs(a[i] - b[i]) <= rounding * length)) return false;
    }
  return true;
}

}  // namespace

bool commutes_with_half_turns(std::span<const double> vectors, const noise_nodes& nodes, int active,
                              const std::function<block_step(const noise_nodes&)>& make) {
  if (active > most_channels) return false;
  const std::vector<double> start(vectors.begin(), vectors.end());
  const auto step = make(nodes);
  const auto commutes = [&](const Eigen::Vector3d& signs, const block_step& turned_step) {
    std::vector<double> straight, turned;
    for (int node = 0; node < static_cast<int>(nodes.weight.size()); ++node) {
      straight = turned = start;
      step(node, straight);
      turn(straight, signs);
      turn(turned, signs);
      turned_step(node, turned);
      if (!same(straight, turned)) return false;
    }
    return true;
  };
  for (const int axis : {1, 2}) {  // the third follows
    bool found = false;
    for (unsigned flipped = 0; flipped < 1u << active && !found; ++flipped)
      found = commutes(half_turns.row(axis).transpose(), make(with_signs(nodes, flipped)));
    if (!found) return false;
  }
  return true;
}

}  // namespace polhode
