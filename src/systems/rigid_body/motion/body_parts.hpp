// SPDX-License-Identifier: Apache-2.0
// What a rigid body and its step size need, as types: what is not there is not compiled.
#pragma once

#include <polhode/lie/so3.hpp>
#include <polhode/lie/so3_near.hpp>

namespace polhode {

/// Parts of the motion. After the Casimir shift by the axis 2 the free motion is two turns, about the axes 1 and 3; a
/// symmetric body is numbered so that its odd axis is 3, and has the first turn alone; a spherical body has none, and
/// no dissipation either, as Pi x Omega = 0.
struct body_parts {
  bool first_turn, last_turn, dissipation;
  bool operator==(const body_parts&) const = default;
};

/// How large the rotations of one step are: it decides how they are evaluated, not what.
enum class rotation_size { tiny, small, moderate, any };

/// Bounds within which the polynomials of a size are good to rounding.
struct rotation_bounds {
  double turn;       ///< angle of a turn about an axis, bounded by the orbit
  double half_turn;  ///< angle of strang's last turn, over half a step
  double generator;  ///< |xi| that is rarely exceeded; lanes beyond take the closed form
  double spread;     ///< of |y|^2 before it is normalised, relative
};

template <rotation_size>
struct rotations {
  using algebra = so3;
};
template <>
struct rotations<rotation_size::small> {
  static constexpr rotation_bounds bounds{0.0075, 0.0075, 0.25, 0.012};
  static constexpr int sine_degree = 2, cosine_degree = 1, norm_degree = 5;
  using algebra = so3_near<5, bounds.generator>;
};
/// Small ones whose turns are shears (shear_rotation). These change lengths by their error, so a dissipation must
/// follow, which restores them.
template <>
struct rotations<rotation_size::tiny> : rotations<rotation_size::small> {
  static constexpr rotation_bounds bounds{0.0075, 0.0017, 0.25, 0.012};
};
template <>
struct rotations<rotation_size::moderate> {
  static constexpr rotation_bounds bounds{0.3, 0.3, 1.0, 0.2};
  static constexpr int sine_degree = 4, cosine_degree = 4, norm_degree = 10;
  using algebra = so3_near<7, bounds.generator>;
};

}  // namespace polhode
