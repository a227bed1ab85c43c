// What a scheme may assume of a system: dmu = ad*_xi mu, xi = a(mu) dt + sum sigma_i o dW^i on the dual of a Lie
// algebra.
#pragma once

#include <concepts>

#include <polhode/increment.hpp>
#include <polhode/vec.hpp>

namespace polhode {

template <class System, class S = double>
using state_of = vec<S, System::algebra::dimension>;

/// A Lie algebra with its coadjoint calculus; see lie/so3.hpp for the meaning of each member.
template <class G>
concept lie_algebra = requires(const vec<double, G::dimension>& v) {
  { G::bracket(v, v) } -> std::same_as<vec<double, G::dimension>>;
  { G::coad(v, v) } -> std::same_as<vec<double, G::dimension>>;
  { G::exp_action(v, v) } -> std::same_as<vec<double, G::dimension>>;
  { G::cayley_action(v, v) } -> std::same_as<vec<double, G::dimension>>;
  { G::orbit_projection(v, v) } -> std::same_as<vec<double, G::dimension>>;
  G::casimirs(v);
};

template <class System>
concept lie_poisson_system = lie_algebra<typename System::algebra> &&
    requires(const System& system, const state_of<System>& mu, const wiener_levy<double, System::channels>& w) {
  { system.generator(mu) } -> std::same_as<state_of<System>>;
  { system.noise(w.dw) } -> std::same_as<state_of<System>>;
  { system.area_noise(w.area) } -> std::same_as<state_of<System>>;
  { system.ito_drift(mu) } -> std::same_as<state_of<System>>;
  { system.energy(mu) } -> std::same_as<double>;
};

/// A system that splits into parts with exact flows; splitting schemes need it.
template <class System>
concept splittable_system = lie_poisson_system<System> &&
    requires(const System& system, const state_of<System>& mu, double dt) {
  { system.free_flow(mu, dt) } -> std::same_as<state_of<System>>;
  { system.dissipation_flow(mu, dt) } -> std::same_as<state_of<System>>;
};

/// xi = a(mu) dt + sum sigma_i dW^i over one step, a taken at mu.
template <class System, class S>
state_of<System, S> generator(const System& system, const state_of<System, S>& mu,
                              const wiener<S, System::channels>& w) {
  return S(w.dt) * system.generator(mu) + system.noise(w.dw);
}

}  // namespace polhode
