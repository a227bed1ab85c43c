// SPDX-License-Identifier: Apache-2.0
// A classical spin with anisotropy in a field, or a gyrostat: any h of degree two on so(3)*.
//
//   dPi = Pi x (Omega + theta Pi x Omega) dt + sum_i Pi x sigma_i o dW^i,   Omega = quadratic Pi + field,
//   h = 1/2 Pi . quadratic Pi + field . Pi                                                             (Stratonovich)
//
// `quadratic` is symmetric of any signature: a multiple of the identity adds a Casimir to h and moves nothing. The
// stochastic Landau-Lifshitz equation dS = -S x (B dt + noise) - lambda S x (S x B) dt with the effective field B =
// -grad E is this with Pi = S, h = E, theta = lambda, sigma = sqrt(2 lambda k_B T). Source: Brown, Phys. Rev. 130
// (1963) 1677-1686; Garcia-Palacios, Lazaro, Phys. Rev. B 58 (1998) 14937-14958.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <utility>

#include <polhode/called.hpp>
#include <polhode/diagonal_form.hpp>
#include <polhode/lie/so3.hpp>
#include <polhode/systems/double_bracket.hpp>
#include <polhode/systems/principal_quadratic.hpp>

namespace polhode {

struct spin : double_bracket<spin, so3> {
  static constexpr bool approximate_dissipation = true;  ///< in a field that is not all of h

  /// quadratic symmetric, theta >= 0.
  spin(const Eigen::Matrix3d& quadratic, const std::array<double, 3>& field_vector, double dissipation,
       constant_noise<so3> noise_vectors)
      : double_bracket(dissipation, std::move(noise_vectors)),
        field{{field_vector[0], field_vector[1], field_vector[2]}},
        diagonal_(quadratic.isDiagonal(0)),
        strength_(std::sqrt(dot(field, field))),
        direction_((strength_ > 0 ? 1 / strength_ : 0) * field) {
    auto [values, axes] = diagonal_form_of(quadratic);
    if (diagonal_) axes.setIdentity();
    if (axes.determinant() < 0) axes.col(0) *= -1;  // a mirrored frame would turn every motion round
    for (int i = 0; i < 3; ++i) {
      principal_.lambda[i] = diagonal_ ? quadratic(i, i) : values[i];
      for (int k = 0; k < 3; ++k) {
        rows_[i][k] = quadratic(i, k);
        axes_[i][k] = axes(k, i);
        across_[k][i] = axes(k, i);
      }
    }
  }

  vec<double, 3> field;

  /// The anisotropy in its own axes, and whether these are the axes 1, 2, 3.
  const principal_quadratic& principal() const { return principal_; }
  bool diagonal() const { return diagonal_; }

  template <class S>
  vec<S, 3> omega(const vec<S, 3>& pi) const {
    return linear(pi) + lifted<S>(field);
  }

  template <class S>
  S energy(const vec<S, 3>& pi) const {
    return dot(pi, S(0.5) * linear(pi) + lifted<S>(field));
  }

  /// The dissipation alone: exact where there is no field or nothing but a field, else both flows in a palindrome, to
  /// second order.
  template <class S>
  POLHODE_CALLED vec<S, 3> dissipation_flow(const vec<S, 3>& pi, double t) const {
    if (theta == 0) return pi;
    if (!has_field()) return kept(damped(pi, t), pi);
    const S c = square_root(dot(pi, pi));
    if (principal_.spherical()) return kept(of_length(c, aligned({c, pi}, root_of(c, t))), pi);
    const S root = root_of(c, t / 2);
    return kept(of_length(c, aligned(weighed(aligned({c, pi}, root).part, c, t), root)), pi);
  }

  /// The motion without dissipation, to second order: half the turn about the field, the quadratic part as a palindrome
  /// of its two turns, half the turn about the field.
  template <class S>
  POLHODE_CALLED vec<S, 3> free_flow(const vec<S, 3>& pi, double t) const {
    return around(pi, t, [&](const vec<S, 3>& x) { return principal_.two_turn_flow(x, t); });
  }

  /// The same in the fewest turns: the first about a principal axis, exact; the last a palindrome of the rest.
  template <class S>
  POLHODE_CALLED vec<S, 3> first_turn(const vec<S, 3>& pi, double t) const {
    if (principal_.spherical()) return pi;
    return kept(in_axes(pi, [&](const vec<S, 3>& x) { return principal_.first_turn(x, t); }), pi);
  }
  template <class S>
  POLHODE_CALLED vec<S, 3> last_turn(const vec<S, 3>& pi, double t) const {
    if (principal_.odd_axis() >= 0) return has_field() ? kept(about_field(pi, t), pi) : pi;
    return around(pi, t, [&](const vec<S, 3>& x) { return principal_.last_turn(x, t); });
  }

 protected:
  template <class S>
  static vec<S, 3> lifted(const vec<double, 3>& v) {
    return {{S(v[0]), S(v[1]), S(v[2])}};
  }

  /// A state but for its length: `part` is a multiple of Pi, of the given length.
  template <class S>
  struct direction_of {
    S length;
    vec<S, 3> part;
  };
  template <class S>
  static vec<S, 3> of_length(const S& c, const direction_of<S>& d) {
    return S(c / select(d.length == S(0.0), S(1.0), d.length)) * d.part;
  }

  /// Pi' = Pi x (Pi x b), b = |b| e, for a time t of either sign, exact: a boost of the null vector (length, part)
  /// along -e, root = exp(-|Pi| |b| t). Of n = Pi/|Pi| the part along e falls like z(t) = tanh(artanh z - |Pi| |b| t).
  template <class S>
  static direction_of<S> boosted(const direction_of<S>& d, const vec<S, 3>& e, const S& root) {
    const S along = dot(d.part, e), square = root * root, less = S(1.0) - root;
    return {(d.length - along) + square * (d.length + along),
            S(2.0) * root * d.part + (less * (less * along - (S(1.0) + root) * d.length)) * e};
  }

 private:
  template <class S>
  static vec<S, 3> times(const vec<vec<double, 3>, 3>& rows, const vec<S, 3>& v) {
    vec<S, 3> out;
    for (int i = 0; i < 3; ++i) out[i] = dot(lifted<S>(rows[i]), v);
    return out;
  }
  template <class S>
  vec<S, 3> linear(const vec<S, 3>& pi) const {
    return diagonal_ ? scaled(principal_.lambda, pi) : times(rows_, pi);
  }
  /// A flow of the principal axes; as what is added to Pi, see about_field.
  template <class S, class Flow>
  vec<S, 3> in_axes(const vec<S, 3>& pi, Flow flow) const {
    if (diagonal_) return flow(pi);
    const auto within = times(axes_, pi);
    return pi + times(across_, flow(within) - within);
  }
  /// Half the turn about the field, a flow of the principal axes, and the other half.
  template <class S, class Flow>
  vec<S, 3> around(const vec<S, 3>& pi, double t, Flow flow) const {
    if (!has_field()) return principal_.spherical() ? pi : kept(in_axes(pi, flow), pi);
    if (principal_.spherical()) return kept(about_field(pi, t), pi);
    return kept(about_field(in_axes(about_field(pi, t / 2), flow), t / 2), pi);
  }
  /// The turn about the field and the principal axes are the same at every step, and keep lengths to rounding only: the
  /// same rounding step after step would let the Casimir drift.
  template <class S>
  vec<S, 3> kept(const vec<S, 3>& after, const vec<S, 3>& before) const {
    if (diagonal_ && !has_field()) return after;
    return so3::orbit_projection(after, before);
  }

  /// Rotation by -t field: one angle for all states. As what is added to Pi, so that what is rounded alike step after
  /// step is small against the step.
  template <class S>
  vec<S, 3> about_field(const vec<S, 3>& pi, double t) const {
    const auto [sin, cos] = sincos(0.5 * t * strength_);
    const auto e = lifted<S>(direction_);
    const auto turned = cross(pi, e);
    return pi + (S(2 * sin * cos) * turned + S(2 * sin * sin) * cross(turned, e));
  }
  template <class S>
  vec<S, 3> damped(const vec<S, 3>& pi, double t) const {
    return in_axes(pi, [&](const vec<S, 3>& y) { return principal_.dissipation_flow(y, theta, t); });
  }

  /// The dissipation of the quadratic part, of a state of length c, but for the length.
  template <class S>
  direction_of<S> weighed(const vec<S, 3>& part, const S& c, double t) const {
    const auto y = in_axes(part, [&](const vec<S, 3>& x) { return principal_.weighed(x, S(c * c), theta * t); });
    return {square_root(dot(y, y)), y};
  }

  /// The dissipation of the field, of a state of length c, is a boost by this root.
  template <class S>
  S root_of(const S& c, double t) const {
    return exponential(S(S(-theta * t * strength_) * c));
  }
  template <class S>
  direction_of<S> aligned(const direction_of<S>& d, const S& root) const {
    return boosted(d, lifted<S>(direction_), root);
  }

  bool has_field() const { return strength_ > 0; }

  bool diagonal_;
  double strength_;           ///< of the field
  vec<double, 3> direction_;  ///< of the field
  principal_quadratic principal_{};
  vec<vec<double, 3>, 3> rows_{}, axes_{}, across_{};  ///< of `quadratic`, of its principal axes, and these transposed
};

}  // namespace polhode
