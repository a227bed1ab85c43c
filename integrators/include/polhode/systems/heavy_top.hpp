// SPDX-License-Identifier: Apache-2.0
// The heavy top: a rigid body with one fixed point under gravity, on the dual of se(3).
//
//   dmu = ad*_{a(mu)} mu dt + sum_i ad*_{sigma_i} mu o dW^i,   a(mu) = Omega + theta ad*_Omega mu       (Stratonovich),
//   mu = (Pi, Gamma),   h = sum_k Pi_k^2 / 2 I_k + weight Gamma.axis,   Omega = grad h = (Pi / I, weight axis)
//
// Without dissipation and noise: Pi' = Pi x Omega + weight Gamma x axis, Gamma' = Gamma x Omega. Gamma is the upward
// vertical and axis the way from the fixed point to the centre of mass, both seen from the body; weight = m g l.
// Source: Arnaudon, De Castro, Holm, arXiv:1601.02249 (semidirect products, the heavy top); Holm, Marsden, Ratiu, Adv.
// Math. 137 (1998) 1-81.
#pragma once

#include <array>
#include <utility>

#include <polhode/lie/se3.hpp>
#include <polhode/systems/double_bracket.hpp>

namespace polhode {

struct heavy_top : double_bracket<heavy_top, se3> {
  static constexpr bool approximate_dissipation = true;

  /// Moments of inertia > 0, any weight and axis, theta >= 0.
  heavy_top(const std::array<double, 3>& inertia, double weight, const std::array<double, 3>& axis, double dissipation,
            constant_noise<se3> noise_vectors)
      : double_bracket(dissipation, std::move(noise_vectors)) {
    for (std::size_t k = 0; k < 3; ++k) {
      inverse_inertia.c[k] = 1 / inertia[k];
      pull.c[k] = weight * axis[k];
    }
  }

  vec<double, 3> inverse_inertia{};
  vec<double, 3> pull{};  ///< weight times axis

  template <class S>
  vec<S, 6> omega(const vec<S, 6>& mu) const {
    return se3::joined(scaled(inverse_inertia, se3::pi(mu)), pulled<S>());
  }
  template <class S>
  S energy(const vec<S, 6>& mu) const {
    const auto pi = se3::pi(mu);
    return S(0.5) * dot(pi, scaled(inverse_inertia, pi)) + dot(se3::gamma(mu), pulled<S>());
  }

  /// The dissipation alone, to second order: the mean of its generators at both ends of an Euler step, as one
  /// exponential.
  template <class S>
  [[gnu::noinline]] vec<S, 6> dissipation_flow(const vec<S, 6>& mu, double t) const {
    return damped(mu, t);
  }
  /// The motion without dissipation, to second order: half a pull, a palindrome of turns, half a pull.
  template <class S>
  [[gnu::noinline]] vec<S, 6> free_flow(const vec<S, 6>& mu, double t) const {
    return first_turn(last_turn(first_turn(mu, t / 2), t), t / 2);
  }
  /// Gravity alone, exact: Pi' = weight Gamma x axis, while Gamma stays.
  template <class S>
  [[gnu::noinline]] vec<S, 6> first_turn(const vec<S, 6>& mu, double t) const {
    return fallen(mu, t);
  }
  /// The kinetic energy alone: turns about the axes 1, 2 (half the time), 3 (all of it), 2, 1 (half), each the exact
  /// flow of its part of h.
  template <class S>
  [[gnu::noinline]] vec<S, 6> last_turn(const vec<S, 6>& mu, double t) const {
    return turned(mu, t);
  }

 protected:
  // The same for whoever wants them inlined.
  template <class S>
  vec<S, 6> damped(const vec<S, 6>& mu, double t) const {
    if (theta == 0) return mu;
    return averaged_flow<se3>([&](const vec<S, 6>& x) { return S(theta * t) * se3::coad(omega(x), x); }, mu);
  }
  template <class S>
  vec<S, 6> fallen(const vec<S, 6>& mu, double t) const {
    return se3::joined(se3::pi(mu) + S(t) * cross(se3::gamma(mu), pulled<S>()), se3::gamma(mu));
  }
  template <class S>
  vec<S, 6> turned(vec<S, 6> mu, double t) const {
    turn<0>(mu, t / 2);
    turn<1>(mu, t / 2);
    turn<2>(mu, t);
    turn<1>(mu, t / 2);
    turn<0>(mu, t / 2);
    return mu;
  }

 private:
  template <class S>
  vec<S, 3> pulled() const {
    return {{S(pull[0]), S(pull[1]), S(pull[2])}};
  }
  /// The flow of Pi_k^2 / 2 I_k: Pi_k stays, and both vectors turn about that axis at its rate.
  template <int axis, class S>
  void turn(vec<S, 6>& mu, double t) const {
    constexpr int next = (axis + 1) % 3, last = (axis + 2) % 3;
    const auto [sin, cos] = sincos(S(S(t * inverse_inertia[axis]) * mu[axis]));
    for (const int part : {0, 3}) {
      const S a = mu[part + next], b = mu[part + last];
      mu[part + next] = a * cos + b * sin;
      mu[part + last] = b * cos - a * sin;
    }
  }
};

}  // namespace polhode
