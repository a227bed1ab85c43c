#include "experiments/uniform_start.hpp"

#include <cmath>
#include <polhode/noise/normal.hpp>

#include "ensemble/kernel.hpp"

namespace polhode {

std::vector<double> uniform_states(std::uint64_t seed, std::uint64_t first_path, double c) {
  std::vector<double> states(3 * block_lanes);
  for (std::size_t lane = 0; lane < block_lanes; ++lane) {
    const auto x = normals<3>({seed, noise_kind::initial_state, first_path + lane, 0});
    const double r = std::sqrt(dot(x, x));
    for (int k = 0; k < 3; ++k) states[static_cast<std::size_t>(k) * block_lanes + lane] = c * x[k] / r;
  }
  return states;
}

}  // namespace polhode
