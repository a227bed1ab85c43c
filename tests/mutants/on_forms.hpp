// SPDX-License-Identifier: Apache-2.0
// The rigid body's own kernel of a scheme, chosen as the laboratory chooses it, with a defect planted on the way.
#pragma once

#include <cmath>
#include <stdexcept>

#include "mutants/defect.hpp"
#include "systems/rigid_body/rigid_body.hpp"
#include "systems/rigid_body/rigid_body_kernels.hpp"

namespace polhode::test {

/// What the choice of a kernel is made for.
struct chosen_step {
  rigid_body body;
  double radius, dt;
  rotation_size size;
};
inline chosen_step chosen_for(const report::scene& s, double dt) {
  const auto body = make_rigid_body(s);
  const double radius = std::hypot(s.momentum[0], s.momentum[1], s.momentum[2]);
  return {body, radius, dt, rotation_size_of(body, radius, dt)};
}

/// The healthy forms.
template <body_parts parts, rotation_size size>
rigid_body_forms<parts, size> forms_of(const chosen_step& s) {
  return {s.body, {constants_of(s.body, s.dt, s.radius, 0, size), no_noise{}}, 0};
}

/// `Scheme` in the place of `Original`, on make<parts, size>(): the original's forms with what is wrong in them. For
/// bodies without symmetry, as all scenes of the table have: the others are not compiled.
template <class Scheme, class Original, class Make>
std::unique_ptr<kernel> kernel_on_forms(const chosen_step& s, const Make& make) {
  return by_parts_and_size<Original>(
      parts_of(s.body), s.size, [&]<body_parts parts, rotation_size size>() -> std::unique_ptr<kernel> {
        if constexpr (parts.first_turn && parts.last_turn) {
          auto forms = make.template operator()<parts, size>();
          using scalar = loop_scalar<Original, size>;
          return std::make_unique<kernel_of<Scheme, decltype(forms), scalar>>(std::move(forms), s.dt);
        } else {
          throw std::invalid_argument("no defect is compiled for a symmetric body");
        }
      });
}

}  // namespace polhode::test
