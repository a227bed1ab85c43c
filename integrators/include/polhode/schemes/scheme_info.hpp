// SPDX-License-Identifier: Apache-2.0
// What a scheme states about itself. Stated once, beside its step; documentation, tests and reports read it from here.
#pragma once

#include <concepts>
#include <string_view>

#include <polhode/systems/lie_poisson.hpp>

namespace polhode {

enum class calculus { ito, stratonovich };

/// Strong order where all noise vectors commute (one vector, say), and for any noise.
struct strong_claim {
  double commuting, general;
};

/// Weak order by class of noise.
struct weak_claim {
  double one_vector, isotropic, general;
};

/// What becomes of the Casimirs over a fixed time: kept to rounding, or a drift of some order in dt (root mean square).
struct casimir_claim {
  bool exact;
  double noisy_order, deterministic_order;
};
inline constexpr casimir_claim keeps_casimirs{true, 0, 0};
constexpr casimir_claim casimirs_drift(double noisy_order, double deterministic_order) {
  return {false, noisy_order, deterministic_order};
}

/// The coordinate map by which a step acts on the orbit, if it does.
enum class group_action { none, cayley, exponential };

struct scheme_info {
  std::string_view name, title, source;
  polhode::calculus calculus;
  strong_claim strong_order;
  weak_claim weak_order;
  int deterministic_order;
  casimir_claim casimir;
  group_action action = group_action::none;
  bool implicit = false;
  bool poisson = false;  ///< a step without noise and dissipation is a Poisson map: J B(mu) J^T = B(step(mu)),
                         ///< B(mu) xi = ad*_xi mu
};

/// A scheme on a system: a pure step that asks for wiener or wiener_levy increments.
template <class Scheme, class System>
concept needs_areas_on = requires(const System& system, const state_of<System>& mu,
                                  const wiener_levy<double, System::channels>& w) {
  { Scheme::step(system, mu, w) } -> std::same_as<state_of<System>>;
}
&&!requires(const System& system, const state_of<System>& mu, const wiener<double, System::channels>& w) {
  {Scheme::step(system, mu, w)};
};

template <class Scheme, class System>
concept scheme_on = requires(const System& system, const state_of<System>& mu,
                             const wiener_levy<double, System::channels>& w) {
  { Scheme::info.name } -> std::convertible_to<std::string_view>;
  { Scheme::step(system, mu, w) } -> std::same_as<state_of<System>>;
};

/// A splitting whose last flow merges with the first of the next step: step = outer(dt/2) inner outer(dt/2), and two
/// `outer` in a row are one of the sum of their times.
template <class Scheme, class System>
concept merges_on = requires {
  requires Scheme::template merges<System>;
}
&&requires(const System& system, const state_of<System>& mu, const wiener<double, System::channels>& w) {
  Scheme::outer(system, Scheme::inner(system, mu, w), half_step{});
};

/// The system as the scheme sees it at this step size: some schemes change the noise vectors once, before the first
/// step.
template <class Scheme, class System>
auto prepared(const System& system, double dt) {
  if constexpr (requires { Scheme::prepare(system, dt); })
    return Scheme::prepare(system, dt);
  else
    return system;
}

}  // namespace polhode
