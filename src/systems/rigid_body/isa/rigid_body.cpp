// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set: the rigid body's plain faces.
#include "systems/rigid_body/rigid_body.hpp"

#include <cmath>

#include "systems/rigid_body/rigid_body_entries.hpp"
#include "systems/system_source.hpp"

namespace polhode {

template class face_of<rigid_body>;

template <>
struct faces_for<rigid_body> {
  static std::shared_ptr<const face> values(const rigid_body& body, std::span<const double> momentum, double dt) {
    if (momentum.empty()) return std::make_shared<face_of<rigid_body>>(body, dt);
    std::shared_ptr<const face> out;
    POLHODE_ENTRY(polhode_rigid_body_face_)(body, std::hypot(momentum[0], momentum[1], momentum[2]), dt, out);
    return out;
  }
  static std::unique_ptr<kernel> own_kernel(std::string_view scheme, const rigid_body& body,
                                            std::span<const double> momentum, double dt) {
    std::unique_ptr<kernel> out;
    POLHODE_ENTRY(polhode_rigid_body_kernel_)(scheme, body, momentum, dt, out);
    return out;
  }
};

}  // namespace polhode

POLHODE_BEHIND_FACES(rigid_body, polhode::make_rigid_body);
