// SPDX-License-Identifier: Apache-2.0
// Chooses the rigid body's kernel for a scene and a step size, outside every loop.
#pragma once

#include <cmath>
#include <memory>

#include "systems/bind.hpp"
#include "systems/rigid_body/rigid_body_choice.hpp"
#include "systems/rigid_body/rigid_body_forms.hpp"

namespace polhode {

/// A system without flows: what a scheme that does not split can still step.
struct unsplit_body : constant_noise<so3> {
  using algebra = so3;
  template <class S>
  vec<S, 3> generator(const vec<S, 3>& pi) const {
    return pi;
  }
  double energy(const vec<double, 3>&) const { return 0; }
};
template <class Scheme>
inline constexpr bool splits = !scheme_on<Scheme, unsplit_body>;

/// One without turns: what a scheme that uses the free motion as a whole can still step.
struct unturned_body : unsplit_body {
  template <class S>
  vec<S, 3> free_flow(const vec<S, 3>& pi, double) const {
    return pi;
  }
  template <class S>
  vec<S, 3> dissipation_flow(const vec<S, 3>& pi, double) const {
    return pi;
  }
  unturned_body with_noise(const constant_noise<so3>&) const { return *this; }
};
template <class Scheme>
inline constexpr bool turns = !scheme_on<Scheme, unturned_body>;

/// The others are made of sums, products and quotients: they have no rotations whose size matters.
template <class Scheme>
inline constexpr bool rotates = Scheme::info.action == group_action::exponential;

/// For a step that is one long chain of products and yet needs few registers (measured: strang with shears, AVX-512).
using four_packs = stdx::fixed_size_simd<double, static_cast<int>(4 * pack::size())>;

/// Long steps hide their latency themselves.
template <class Scheme, rotation_size size>
using loop_scalar = std::conditional_t<
    rotates<Scheme> && size == rotation_size::any, pack,
    std::conditional_t<turns<Scheme> && size == rotation_size::tiny && pack::size() == 8, four_packs, loop_pack>>;

template <class Scheme, body_parts parts, class Make>
std::unique_ptr<kernel> by_rotation_size(rotation_size size, const Make& make) {
  if constexpr (rotates<Scheme>) {
    if constexpr (turns<Scheme> && parts.dissipation)
      if (size == rotation_size::tiny) return make.template operator()<parts, rotation_size::tiny>();
    if (size <= rotation_size::small) return make.template operator()<parts, rotation_size::small>();
    if (size == rotation_size::moderate) return make.template operator()<parts, rotation_size::moderate>();
  }
  return make.template operator()<parts, rotation_size::any>();
}

/// make<parts, size>(): only the parts that the scheme can tell apart (one that moves by a(Pi) as a whole has no turns
/// to leave out), and a size only where it rotates.
template <class Scheme, class Make>
std::unique_ptr<kernel> by_parts_and_size(body_parts parts, rotation_size size, const Make& make) {
  if constexpr (splits<Scheme>)
    if (!parts.first_turn) return by_rotation_size<Scheme, body_parts{false, false, false}>(size, make);
  if constexpr (turns<Scheme>)
    if (!parts.last_turn)
      return parts.dissipation ? by_rotation_size<Scheme, body_parts{true, false, true}>(size, make)
                               : by_rotation_size<Scheme, body_parts{true, false, false}>(size, make);
  return parts.dissipation ? by_rotation_size<Scheme, body_parts{true, true, true}>(size, make)
                           : by_rotation_size<Scheme, body_parts{true, true, false}>(size, make);
}

template <class Scheme>
std::unique_ptr<kernel> kernel_for(scheme_tag<Scheme>, const rigid_body& body, const std::vector<double>& momentum,
                                   double dt) {
  const auto prepared_body = prepared<Scheme>(body, dt);
  const double radius = std::hypot(momentum[0], momentum[1], momentum[2]);
  const auto make = [&]<body_parts parts, rotation_size size>() -> std::unique_ptr<kernel> {
    const int axis = parts.last_turn ? 0 : first_axis_of(prepared_body);
    const auto constants = constants_of(prepared_body, dt, radius, axis, size);
    using forms = rigid_body_forms<parts, size>;
    return std::make_unique<kernel_of<Scheme, forms, loop_scalar<Scheme, size>>>(
        forms(prepared_body, {constants, no_noise{}}, axis), dt);
  };
  return by_parts_and_size<Scheme>(parts_of(body), rotation_size_of(prepared_body, radius, dt), make);
}

}  // namespace polhode
