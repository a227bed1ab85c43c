// SPDX-License-Identifier: Apache-2.0
// The loop that an outside user calls: one path of one scheme, noise by address.
#pragma once

#include <cmath>
#include <cstdint>

#include <polhode/noise/normal.hpp>
#include <polhode/schemes/scheme_info.hpp>

namespace polhode {

/// The Wiener increments of (seed, path) at `step`. `active`: how many channels the system uses; the rest is zero.
/// `channels`: how many there are, where M < 0 leaves that to the program.
template <int M>
wiener<double, M> wiener_at(const noise_address& address, double dt, int active = M, int channels = M) {
  auto dw = zeros<vec<double, M>>(channels);
  for (int i = 0; i < active; i += 2) {
    const auto pair = normal_pair(address, static_cast<std::uint32_t>(i / 2));
    dw[i] = std::sqrt(dt) * pair[0];
    if (i + 1 < active) dw[i + 1] = std::sqrt(dt) * pair[1];
  }
  return {dt, dw};
}

/// State after `steps` steps of size dt from mu. For schemes that ask for Wiener increments alone: areas of a single
/// step have no cheap exact law (build them with chen() from finer increments and call Scheme::step). A failed implicit
/// step gives NaN, which stays.
template <class Scheme, lie_poisson_system System>
requires scheme_on<Scheme, System> &&
    (!needs_areas_on<Scheme, System>)state_of<System> integrate(const System& system, state_of<System> mu, double dt,
                                                                std::uint64_t steps, noise_address address = {}) {
  const auto stepped = prepared<Scheme>(system, dt);
  const int active = system.active_channels();
  for (std::uint64_t i = 0; i < steps; ++i, ++address.step)
    mu = Scheme::step(stepped, mu, wiener_at<System::channels>(address, dt, active, mu.size));
  return mu;
}

}  // namespace polhode
