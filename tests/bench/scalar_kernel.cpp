// SPDX-License-Identifier: Apache-2.0
// The laboratory's loop with a double in the place of a pack.
#include <polhode/schemes/heun.hpp>
#include <polhode/schemes/lie_heun.hpp>
#include <polhode/schemes/strang.hpp>
#include <polhode/systems/rigid_body.hpp>

#include "bench/yardsticks.hpp"
#include "ensemble/kernel_of.hpp"
#include "ensemble/noise/paths.hpp"
#include "ensemble/plain_forms.hpp"

namespace polhode::bench {
namespace {

template <class Scheme>
std::vector<double> walked(const momentum& start, std::span<const double> dw, int steps, double dt) {
  using scalar = stdx::simd<double, stdx::simd_abi::scalar>;
  const auto body = prepared<Scheme>(rigid_body({1, 2, 3}, 0.5, rigid_body::isotropic(0.5)), dt);
  const kernel_of<Scheme, plain_forms<rigid_body>, scalar> loop(plain_forms<rigid_body>(body), dt);
  auto states = replicated(std::vector<double>(start.begin(), start.end()));
  loop.advance(states, increment_view{steps, dw, {}}, piece{true, true});
  return states;
}

}  // namespace

std::vector<double> by_scalar_kernel(yard_scheme scheme, momentum start, std::span<const double> dw, int steps,
                                     double dt) {
  return scheme == yard_scheme::heun     ? walked<heun>(start, dw, steps, dt)
         : scheme == yard_scheme::strang ? walked<strang>(start, dw, steps, dt)
                                         : walked<lie_heun>(start, dw, steps, dt);
}

}  // namespace polhode::bench
