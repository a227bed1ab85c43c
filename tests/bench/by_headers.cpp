// SPDX-License-Identifier: Apache-2.0
// A program outside: of polhode it has the installed headers alone.
#include <polhode/integrate.hpp>
#include <polhode/schemes/heun.hpp>
#include <polhode/schemes/lie_heun.hpp>
#include <polhode/schemes/strang.hpp>
#include <polhode/systems/rigid_body.hpp>

#include "bench/yardsticks.hpp"

namespace polhode::bench {
namespace {

constexpr std::size_t paths = 64;

template <class Scheme>
std::vector<double> walked(const momentum& start, std::span<const double> dw, int steps, double dt) {
  const rigid_body body({1, 2, 3}, 0.5, rigid_body::isotropic(0.5));
  std::vector<vec<double, 3>> states(paths, {{start[0], start[1], start[2]}});
  advance<Scheme>(body, std::span(states), dt, static_cast<std::uint64_t>(steps),
                  [&](std::uint64_t step, std::size_t path) {
                    const double* at = dw.data() + 3 * paths * step + path;
                    return wiener<double, 3>{dt, {{at[0], at[paths], at[2 * paths]}}};
                  });
  std::vector<double> out(3 * paths);
  for (std::size_t p = 0; p < paths; ++p)
    for (std::size_t k = 0; k < 3; ++k) out[k * paths + p] = states[p].c[k];
  return out;
}

}  // namespace

std::vector<double> by_headers(yard_scheme scheme, momentum start, std::span<const double> dw, int steps, double dt) {
  return scheme == yard_scheme::heun     ? walked<heun>(start, dw, steps, dt)
         : scheme == yard_scheme::strang ? walked<strang>(start, dw, steps, dt)
                                         : walked<lie_heun>(start, dw, steps, dt);
}

}  // namespace polhode::bench
