// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set: kernels of the rigid body and one scheme each.
#include "systems/kernel_for.hpp"
#include "systems/rigid_body/rigid_body_entries.hpp"
#include "systems/rigid_body/rigid_body_kernels.hpp"

namespace polhode {
namespace {

/// Steps of so few operations that one more pass over memory would take half of the time again; and those that solve
/// equations, all in registers.
using own_schemes =
    scheme_list<euler_maruyama, heun, milstein, milstein_no_area, implicit_midpoint, isospectral_midpoint>;

}  // namespace
}  // namespace polhode

extern "C" void POLHODE_ENTRY(polhode_rigid_body_kernel_)(std::string_view scheme, const polhode::rigid_body& body,
                                                          std::span<const double> momentum, double dt,
                                                          std::unique_ptr<polhode::kernel>& out) {
  out = polhode::kernel_among(polhode::own_schemes{}, scheme, body, {momentum.begin(), momentum.end()}, dt);
}
