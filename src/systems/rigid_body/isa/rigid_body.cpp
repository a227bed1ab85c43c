// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set: the rigid body's faces, and kernels of its own.
#include "systems/rigid_body/rigid_body.hpp"

#include <cmath>

#include "systems/rigid_body/rigid_body_face.hpp"
#include "systems/rigid_body/rigid_body_kernels.hpp"
#include "systems/schemes.hpp"
#include "systems/system_source.hpp"

namespace polhode {
namespace {

/// Steps of so few operations that one more pass over memory would take half of the time again; and those that solve
/// equations, all in registers.
using own_schemes =
    scheme_list<euler_maruyama, heun, milstein, milstein_no_area, implicit_midpoint, isospectral_midpoint>;

}  // namespace

template <>
struct faces_for<rigid_body> {
  static std::shared_ptr<const face> values(const rigid_body& body, std::span<const double> momentum, double dt) {
    if (momentum.empty()) return std::make_shared<face_of<rigid_body>>(body, dt);
    return bound_face_of(body, std::hypot(momentum[0], momentum[1], momentum[2]), dt);
  }
  static std::unique_ptr<kernel> own_kernel(std::string_view scheme, const rigid_body& body,
                                            std::span<const double> momentum, double dt) {
    return kernel_among(own_schemes{}, scheme, body, {momentum.begin(), momentum.end()}, dt);
  }
};

}  // namespace polhode

POLHODE_BEHIND_FACES(rigid_body, polhode::make_rigid_body);
