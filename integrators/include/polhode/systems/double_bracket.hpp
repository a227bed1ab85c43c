// SPDX-License-Identifier: Apache-2.0
// Motion on the dual of a Lie algebra with double-bracket dissipation: what every such system has beside its energy.
//
//   dmu = ad*_{a(mu)} mu dt + sum_i ad*_{sigma_i} mu o dW^i,   a(mu) = Omega + theta ad*_Omega mu,   Omega = grad h
//
// Without noise dh/dt = -theta |ad*_Omega mu|^2: theta >= 0 takes energy and keeps every Casimir. On so(3)* ad*_Omega
// mu is mu x Omega. Source: Arnaudon, De Castro, Holm, arXiv:1606.06308, eqs. (3.4) and (3.5).
#pragma once

#include <utility>

#include <polhode/systems/constant_noise.hpp>
#include <polhode/systems/lie_poisson.hpp>
#include <polhode/vec.hpp>

namespace polhode {

/// Ad*_exp((x(mu) + x(nu)) / 2) mu, nu = Ad*_exp(x(mu)) mu: the flow of mu' = ad*_x mu for a time one, to second order
/// in the size of x.
template <class G, class Generator, class State>
State averaged_flow(Generator x, const State& mu) {
  const auto first = x(mu);
  using S = typename State::scalar;
  return G::exp_action(S(0.5) * (first + x(G::exp_action(first, mu))), mu);
}

/// A base of System, which has omega(mu), the gradient of h, and energy(mu); G: its Lie algebra.
template <class System, class G>
struct double_bracket : constant_noise<G> {
  using algebra = G;

  double_bracket(double dissipation, constant_noise<G> noise_vectors)
      : constant_noise<G>(std::move(noise_vectors)), theta(dissipation) {}

  double theta;

  /// The same system with other noise vectors.
  System with_noise(constant_noise<G> other) const {
    System copy = self();
    static_cast<constant_noise<G>&>(copy) = std::move(other);
    return copy;
  }

  /// a(mu).
  template <class S>
  vec<S, G::dimension> generator(const vec<S, G::dimension>& mu) const {
    const auto w = self().omega(mu);
    return w + S(theta) * G::coad(w, mu);
  }

  /// -dh/dt without noise.
  template <class S>
  S dissipation_rate(const vec<S, G::dimension>& mu) const {
    const auto c = G::coad(self().omega(mu), mu);
    return S(theta) * dot(c, c);
  }

 private:
  const System& self() const { return static_cast<const System&>(*this); }
};

}  // namespace polhode
