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

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <utility>

#include <polhode/called.hpp>
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
        has_field_(field[0] != 0 || field[1] != 0 || field[2] != 0) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(quadratic);
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
    if (!diagonal_) axes = eigen.eigenvectors();
    if (axes.determinant() < 0) axes.col(0) *= -1;  // a mirrored frame would turn every motion round
    for (int i = 0; i < 3; ++i) {
      principal_.lambda[i] = diagonal_ ? quadratic(i, i) : eigen.eigenvalues()[i];
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
    if (!has_field_) return kept(damped(pi, t), pi);
    if (principal_.spherical()) return kept(aligned_with_field(pi, t), pi);
    return kept(aligned_with_field(damped(aligned_with_field(pi, t / 2), t), t / 2), pi);
  }

  /// The motion without dissipation, to second order: half the turn about the field, that of the quadratic part, half
  /// the turn about the field.
  template <class S>
  POLHODE_CALLED vec<S, 3> free_flow(const vec<S, 3>& pi, double t) const {
    return around(pi, t, [&](const vec<S, 3>& x) { return principal_.free_flow(x, t); });
  }

  /// The same in the fewest turns: the first about a principal axis, exact; the last a palindrome of the rest.
  template <class S>
  POLHODE_CALLED vec<S, 3> first_turn(const vec<S, 3>& pi, double t) const {
    if (principal_.spherical()) return pi;
    return kept(in_axes(pi, [&](const vec<S, 3>& x) { return principal_.first_turn(x, t); }), pi);
  }
  template <class S>
  POLHODE_CALLED vec<S, 3> last_turn(const vec<S, 3>& pi, double t) const {
    if (principal_.odd_axis() >= 0) return has_field_ ? kept(about_field(pi, t), pi) : pi;
    return around(pi, t, [&](const vec<S, 3>& x) { return principal_.last_turn(x, t); });
  }

 protected:
  template <class S>
  static vec<S, 3> lifted(const vec<double, 3>& v) {
    return {{S(v[0]), S(v[1]), S(v[2])}};
  }

  /// Pi' = Pi x (Pi x b), b = |b| e, for a time t of either sign, exact; amount = |b| t. Of n = Pi/c the part across e
  /// shrinks and z = n.e falls, by
  ///   z(t) = (z (1 + E) - (1 - E)) / d,  across(t) = across 2 sqrt(E) / d,  d = 1 - z + E (1 + z),
  /// E = exp(-2 c amount): z(t) = tanh(artanh z - c amount) without its poles.
  template <class S>
  static vec<S, 3> aligned(const vec<S, 3>& pi, const vec<S, 3>& e, const S& amount) {
    const S c = square_root(dot(pi, pi)), along = dot(pi, e), z = along / c;
    const S root = exponential(S(-amount * c)), square = root * root;
    const S d = (S(1.0) - z) + square * (S(1.0) + z);
    const auto across = pi - along * e;
    return (S(2.0) * root / d) * across + (c * (z * (S(1.0) + square) - (S(1.0) - square)) / d) * e;
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
    if (!has_field_) return principal_.spherical() ? pi : kept(in_axes(pi, flow), pi);
    if (principal_.spherical()) return kept(about_field(pi, t), pi);
    return kept(about_field(in_axes(about_field(pi, t / 2), flow), t / 2), pi);
  }
  /// The turn about the field and the principal axes are the same at every step, and keep lengths to rounding only: the
  /// same rounding step after step would let the Casimir drift.
  template <class S>
  vec<S, 3> kept(const vec<S, 3>& after, const vec<S, 3>& before) const {
    return diagonal_ && !has_field_ ? after : so3::orbit_projection(after, before);
  }

  /// Rotation by -t field: one angle for all states. As what is added to Pi, so that what is rounded alike step after
  /// step is small against the step.
  template <class S>
  vec<S, 3> about_field(const vec<S, 3>& pi, double t) const {
    const double strength = std::sqrt(dot(field, field));
    const auto [sin, cos] = sincos(0.5 * t * strength);
    const auto e = lifted<S>((1 / strength) * field);
    const auto turned = cross(pi, e);
    return pi + (S(2 * sin * cos) * turned + S(2 * sin * sin) * cross(turned, e));
  }
  template <class S>
  vec<S, 3> damped(const vec<S, 3>& pi, double t) const {
    return in_axes(pi, [&](const vec<S, 3>& y) { return principal_.dissipation_flow(y, theta, t); });
  }

  template <class S>
  vec<S, 3> aligned_with_field(const vec<S, 3>& pi, double t) const {
    const double strength = std::sqrt(dot(field, field));
    return aligned(pi, lifted<S>((1 / strength) * field), S(theta * t * strength));
  }

  bool diagonal_, has_field_;
  principal_quadratic principal_{};
  vec<vec<double, 3>, 3> rows_{}, axes_{}, across_{};  ///< of `quadratic`, of its principal axes, and these transposed
};

}  // namespace polhode
