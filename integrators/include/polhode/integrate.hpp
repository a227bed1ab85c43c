// SPDX-License-Identifier: Apache-2.0
// The loops that an outside user calls: paths of one scheme, with increments of their own or with noise by address.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

#include <polhode/flatten.hpp>
#include <polhode/noise/normal.hpp>
#include <polhode/schemes/scheme_info.hpp>

namespace polhode {

/// The Wiener increments of (seed, path) at `step`. `active`: how many channels the system uses; the rest is zero.
/// `channels`: how many there are, where M < 0 leaves that to the program. Called, not inlined: beside the normals a
/// call costs nothing, and the loops below stay short for the compiler.
template <int M>
[[gnu::noinline]] wiener<double, M> wiener_at(const noise_address& address, double dt, int active = M,
                                              int channels = M) {
  auto dw = zeros<vec<double, M>>(channels);
  for (int i = 0; i < active; i += 2) {
    const auto pair = normal_pair(address, static_cast<std::uint32_t>(i / 2));
    dw[i] = std::sqrt(dt) * pair[0];
    if (i + 1 < active) dw[i + 1] = std::sqrt(dt) * pair[1];
  }
  return {dt, dw, dt * static_cast<double>(address.step)};
}

namespace detail {

template <class Scheme, class Stepped, class State, class Increment>
void steps_of(const Stepped stepped, std::span<State> paths, double dt, std::uint64_t steps,
              const Increment& increment) {
  if constexpr (merges_on<Scheme, Stepped>) {
    if (steps == 0) return;
    for (auto& mu : paths) mu = Scheme::outer(stepped, mu, dt / 2);
    for (std::uint64_t i = 0; i < steps; ++i) {
      const double t = i + 1 < steps ? dt : dt / 2;
      for (std::size_t p = 0; p < paths.size(); ++p)
        paths[p] = Scheme::outer(stepped, Scheme::inner(stepped, paths[p], increment(i, p)), t);
    }
  } else {
    for (std::uint64_t i = 0; i < steps; ++i)
      for (std::size_t p = 0; p < paths.size(); ++p) paths[p] = Scheme::step(stepped, paths[p], increment(i, p));
  }
}

template <class Scheme, class... Arguments>
POLHODE_FLATTEN void steps_in_registers(Arguments&&... arguments) {
  steps_of<Scheme>(std::forward<Arguments>(arguments)...);
}

}  // namespace detail

/// `steps` steps of size dt of paths side by side. `increment(step, path)`: of that step of that path, wiener<double,
/// M> or, for schemes that ask for areas too, wiener_levy<double, M>. A failed implicit step gives NaN, which stays.
template <class Scheme, lie_poisson_system System, class Increment>
requires scheme_on<Scheme, System>
void advance(const System& system, std::span<state_of<System>> paths, double dt, std::uint64_t steps,
             const Increment& increment) {
  constexpr bool fits = System::dimension > 0 && System::dimension <= 6;  // what is longer gains nothing
  if constexpr (fits)
    detail::steps_in_registers<Scheme>(prepared<Scheme>(system, dt), paths, dt, steps, increment);
  else
    detail::steps_of<Scheme>(prepared<Scheme>(system, dt), paths, dt, steps, increment);
}

/// State after `steps` steps of size dt from mu. For schemes that ask for Wiener increments alone: areas of a single
/// step have no cheap exact law (build them with chen() from finer increments and call advance). A failed implicit step
/// gives NaN, which stays.
template <class Scheme, lie_poisson_system System>
requires scheme_on<Scheme, System> &&
    (!needs_areas_on<Scheme, System>)state_of<System> integrate(const System& system, state_of<System> mu, double dt,
                                                                std::uint64_t steps, noise_address address = {}) {
  const int active = system.active_channels(), channels = channels_of(system);
  const auto first = address.step;
  advance<Scheme>(system, std::span(&mu, 1), dt, steps, [&](std::uint64_t step, std::size_t) {
    address.step = first + step;
    return wiener_at<System::channels>(address, dt, active, channels);
  });
  return mu;
}

}  // namespace polhode
