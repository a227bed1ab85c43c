// SPDX-License-Identifier: Apache-2.0
// Two bodies, or two spins, coupled through the energy: the dissipative stochastic top on so(4)* = so(3)* + so(3)*.
//
//   dmu = ad*_{Omega + theta ad*_Omega mu} mu dt + sum_i ad*_{sigma_i} mu o dW^i,   Omega = grad h   (Stratonovich)
//
//   h = 1/2 sum_k mu_k^2 / I_k + coupling (mu_1, mu_2, mu_3) . (mu_4, mu_5, mu_6)
//
// Source: Arnaudon, De Castro, Holm, arXiv:1601.02249 (noise and dissipation on coadjoint orbits).
#pragma once

#include <array>
#include <cmath>
#include <utility>

#include <polhode/lie/so4.hpp>
#include <polhode/systems/double_bracket.hpp>
#include <polhode/systems/pair_energy.hpp>
#include <polhode/systems/principal_quadratic.hpp>

namespace polhode {

struct so4_body : double_bracket<so4_body, so4> {
  static constexpr bool approximate_dissipation = true;  ///< where the bodies are coupled

  /// Moments of inertia > 0, any coupling, theta >= 0.
  so4_body(const std::array<double, 6>& inertia, double coupling_constant, double dissipation,
           constant_noise<so4> noise_vectors)
      : double_bracket(dissipation, std::move(noise_vectors)), coupling(coupling_constant) {
    for (int k = 0; k < 6; ++k) inverse_inertia[k] = 1 / inertia[static_cast<std::size_t>(k)];
  }

  vec<double, 6> inverse_inertia{};
  double coupling;

  template <class S>
  vec<S, 6> omega(const vec<S, 6>& mu) const {
    return scaled(inverse_inertia, mu) + S(coupling) * so4::joined(so4::part(mu, 1), so4::part(mu, 0));
  }
  template <class S>
  S energy(const vec<S, 6>& mu) const {
    return S(0.5) * dot(mu, omega(mu));
  }

  /// The dissipation alone, to second order: half of the coupling's, that of each body, half of the coupling's.
  template <class S>
  [[gnu::noinline]] vec<S, 6> dissipation_flow(const vec<S, 6>& mu, double t) const {
    if (theta == 0) return mu;
    return parted(bodies(parted(mu, t / 2),
                         [&](int which, const vec<S, 3>& x) { return body(which).dissipation_flow(x, theta, t); }),
                  t / 2);
  }
  /// The motion without dissipation, to second order: half of the coupling, both bodies, half of the coupling.
  template <class S>
  [[gnu::noinline]] vec<S, 6> free_flow(const vec<S, 6>& mu, double t) const {
    return first_turn(last_turn(first_turn(mu, t / 2), t), t / 2);
  }
  /// The coupling alone, exact: the sum of both parts stays, and both turn about it.
  template <class S>
  [[gnu::noinline]] vec<S, 6> first_turn(const vec<S, 6>& mu, double t) const {
    if (coupling == 0) return mu;
    return about_the_sum(mu, t * coupling);
  }
  /// Both bodies by themselves, each a palindrome of three turns.
  template <class S>
  [[gnu::noinline]] vec<S, 6> last_turn(const vec<S, 6>& mu, double t) const {
    return bodies(mu, [&](int which, const vec<S, 3>& x) {
      const auto b = body(which);
      return b.spherical() ? x : b.first_turn(b.last_turn(b.first_turn(x, t / 2), t), t / 2);
    });
  }

 protected:
  template <class S>
  static vec<S, 6> about_the_sum(const vec<S, 6>& mu, double k) {
    const auto a = so4::part(mu, 0), b = so4::part(mu, 1), gained = gained_about_sum(S(k), a, b);
    return so4::joined(a + gained, b - gained);
  }

 private:
  principal_quadratic body(int which) const {
    return {{{inverse_inertia[3 * which], inverse_inertia[3 * which + 1], inverse_inertia[3 * which + 2]}}};
  }
  template <class S, class F>
  static vec<S, 6> bodies(const vec<S, 6>& mu, F flow) {
    return so4::joined(flow(0, so4::part(mu, 0)), flow(1, so4::part(mu, 1)));
  }

  /// The dissipation of the coupling alone, exact. a' = k a x (a x b), b' = k b x (b x a), k = theta coupling, turns
  /// the directions of a and b in their plane, at equal rates: tan(phi/2) of the angle between them grows by exp(2 k
  /// |a| |b| t), and the direction of their bisector stays.
  template <class S>
  vec<S, 6> parted(const vec<S, 6>& mu, double t) const {
    if (coupling == 0) return mu;
    const auto a = so4::part(mu, 0), b = so4::part(mu, 1);
    const S length_a = square_root(dot(a, a)), length_b = square_root(dot(b, b));
    const auto direction = [](const vec<S, 3>& v, const S& length) {
      return select(length == S(0.0), S(0.0), S(S(1.0) / length)) * v;
    };
    const auto first = direction(a, length_a), second = direction(b, length_b);
    // Each of both parts by the root of the growth, so that neither leaves double precision alone.
    const S grown = exponential(S(S(theta * coupling * t) * (length_a * length_b)));
    const auto sum = (S(1.0) / grown) * (first + second), difference = grown * (first - second);
    const S size = square_root(dot(sum, sum) + dot(difference, difference));
    const S scale = select(size == S(0.0), S(0.0), S(S(1.0) / size));
    const auto there = so4::joined(S(length_a * scale) * (sum + difference), S(length_b * scale) * (sum - difference));
    return so4::orbit_projection(there, mu);
  }
};

}  // namespace polhode
