// SPDX-License-Identifier: Apache-2.0
// A spinning satellite that sloshing fuel damps and heat shakes: it ends up turning about its largest axis, but for kT.
#include <cmath>
#include <cstdio>
#include <polhode/integrate.hpp>
#include <polhode/schemes/strang_two_turns.hpp>
#include <polhode/systems/rigid_body.hpp>

int main() {
  using namespace polhode;
  const double theta = 0.2, kT = 0.01;  // sigma^2 = 2 theta kT: the Gibbs law exp(-h/kT) on the sphere of |Pi|
  const rigid_body satellite({1, 2, 3}, theta, rigid_body::isotropic(std::sqrt(2 * theta * kT)));
  const vec<double, 3> start{{0.99, 0.1, 0.1}};  // it spins about its smallest axis
  constexpr int paths = 1000;
  double energy = 0, drift = 0;
  for (std::uint64_t path = 0; path < paths; ++path) {
    const auto pi = integrate<strang_two_turns>(satellite, start, 0.05, 2000, {.seed = 1, .path = path});
    energy += satellite.energy(pi) / paths;
    drift = std::fmax(drift, std::fabs(dot(pi, pi) / dot(start, start) - 1));
  }
  const double least = dot(start, start) / 6;  // all of Pi along the axis of inertia 3
  std::printf("h: %.4f at the start, %.4f at the end, least %.4f; |Pi|^2 has changed by %.0e\n",
              satellite.energy(start), energy, least, drift);
  // Two directions beside the axis, kT/2 each, to first order in kT.
  return std::fabs(energy - least - kT) < 0.15 * kT && drift < 1e-12 ? 0 : 1;
}
