// SPDX-License-Identifier: Apache-2.0
// Bodies spread evenly over a sphere, by address.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace polhode {

/// A block of bodies, [component][lane]: body first_body + lane starts at the radius times the direction of the three
/// normals at its own address.
void start_uniformly(std::uint64_t seed, std::uint64_t first_body, double radius, std::span<double> states);
/// The same as a new block.
std::vector<double> uniform_states(std::uint64_t seed, std::uint64_t first_body, double radius);

}  // namespace polhode
