// Where long runs on the sphere start.
#pragma once

#include <cstdint>
#include <vector>

namespace polhode {

/// Uniform points of a block of paths on the sphere of radius c, by address.
std::vector<double> uniform_states(std::uint64_t seed, std::uint64_t first_path, double c);

}  // namespace polhode
