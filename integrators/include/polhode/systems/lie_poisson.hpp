// SPDX-License-Identifier: Apache-2.0
// What a scheme may assume of a system: dmu = ad*_xi mu, xi = a(mu) dt + sum sigma_i o dW^i on the dual of a Lie
// algebra.
#pragma once

#include <concepts>

#include <polhode/dual.hpp>
#include <polhode/increment.hpp>
#include <polhode/solve.hpp>
#include <polhode/vec.hpp>

namespace polhode {

template <class System, class S = double>
using state_of = vec<S, System::algebra::dimension>;

/// Components of the state; those of a system with dimension < 0 (at most -dimension) are known at run time alone.
template <class System>
constexpr int dimension_of(const System& system) {
  if constexpr (System::dimension < 0)
    return system.components();
  else
    return System::dimension;
}
/// Wiener processes.
template <class System>
constexpr int channels_of(const System& system) {
  if constexpr (System::channels < 0)
    return system.components();
  else
    return System::channels;
}

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

/// A vector of the system's algebra, or the zero that stands for an absent term.
template <class T, class System>
concept element_of = std::same_as<T, state_of<System>> || std::same_as<T, zero_vector>;

template <class System>
concept lie_poisson_system = lie_algebra<typename System::algebra> &&
    requires(const System& system, const state_of<System>& mu, const wiener_levy<double, System::channels>& w) {
  { system.generator(mu) } -> std::same_as<state_of<System>>;
  { system.ito_drift(mu) } -> element_of<System>;
  { system.energy(mu) } -> std::same_as<double>;
} &&(
    requires(const System& system, const wiener_levy<double, System::channels>& w) {
      { system.noise(w.dw) } -> element_of<System>;
      { system.area_noise(w.area) } -> element_of<System>;
    } ||
    requires(const System& system, const state_of<System>& mu, const wiener<double, System::channels>& w) {
      { system.noise_at(mu, w) } -> element_of<System>;
    });

/// One whose noise vectors are the same at every state.
template <class System>
concept constant_noise_system = lie_poisson_system<System> &&
    requires(const System& system, const wiener<double, System::channels>& w) {
  system.noise(w.dw);
};

/// One whose noise fields have brackets that are known: constant vectors, or ones with their derivatives.
template <class System>
concept bracketed_noise_system = constant_noise_system<System> ||
    requires(const System& system, const state_of<System>& mu, const wiener_levy<double, System::channels>& w) {
  { system.area_noise_at(mu, w.area) } -> element_of<System>;
  { system.noise_slope_at(mu, w, mu) } -> element_of<System>;
};

/// A system that splits into parts with flows of their own; splitting schemes need it.
template <class System>
concept splittable_system = lie_poisson_system<System> &&
    requires(const System& system, const state_of<System>& mu, half_step t) {
  { system.free_flow(mu, t) } -> std::same_as<state_of<System>>;
  { system.dissipation_flow(mu, t) } -> std::same_as<state_of<System>>;
};

/// Whether two of the system's dissipation flows in a row are one of the sum of their times. A system that has but a
/// flow of second order says `approximate_dissipation`.
template <class System>
inline constexpr bool exact_dissipation = !requires {
  requires System::approximate_dissipation;
};

/// One whose free motion splits into two turns, each the exact flow of its part of h plus a Casimir.
template <class System>
concept turning_system = splittable_system<System> &&
    requires(const System& system, const state_of<System>& mu, half_step t) {
  { system.first_turn(mu, t) } -> std::same_as<state_of<System>>;
  { system.last_turn(mu, t) } -> std::same_as<state_of<System>>;
};

// What a step is built of. A system that knows better (a term that is not there, a constant that is computed once) says
// so by a member of the same name.

/// sum sigma_i dW^i over one step, sigma_i taken at mu where they depend on the state. Of an increment this and
/// area_noise are all that a scheme may ask: what stands in it is between the system and the loop.
template <class System, class S>
auto noise(const System& system, const state_of<System, S>& mu, const wiener<S, System::channels>& w) {
  if constexpr (requires { system.noise_at(mu, w); })
    return system.noise_at(mu, w);
  else
    return system.noise(w.dw);
}

/// sum_{i<j} A^ij [sigma_i, sigma_j] over one step: the bracket of the fields V_i(mu) = ad*_{sigma_i} mu, so that
/// vectors that depend on the state add D sigma_j [V_i] - D sigma_i [V_j].
template <bracketed_noise_system System, class S>
auto area_noise(const System& system, const state_of<System, S>& mu, const wiener_levy<S, System::channels>& w) {
  if constexpr (constant_noise_system<System>)
    return system.area_noise(w.area);
  else
    return system.area_noise_at(mu, w.area);
}

/// DB(mu)[B(mu)], B(mu) = ad*_b mu, b = sum sigma_i dW^i: ad*_b ad*_b mu, and where b depends on the state
/// ad*_{Db[B]} mu besides.
template <bracketed_noise_system System, class S>
auto noise_twice(const System& system, const state_of<System, S>& mu, const wiener<S, System::channels>& w) {
  if constexpr (requires { system.noise_twice_over(mu, w); }) {
    return system.noise_twice_over(mu, w);
  } else {
    using g = typename System::algebra;
    const auto b = noise(system, mu, w);
    const auto once = g::coad(b, mu);
    if constexpr (constant_noise_system<System>)
      return g::coad(b, once);
    else
      return g::coad(b, once) + g::coad(system.noise_slope_at(mu, w, once), mu);
  }
}

/// xi = a(mu) dt + sum sigma_i dW^i over one step, both taken at mu.
template <class System, class S>
state_of<System, S> generator(const System& system, const state_of<System, S>& mu,
                              const wiener<S, System::channels>& w) {
  if constexpr (requires { system.generator_over(mu, w); })
    return system.generator_over(mu, w);
  else
    return S(w.dt) * system.generator(mu) + noise(system, mu, w);
}

/// The part a(mu) dt of the same.
template <class System, class S>
auto drift(const System& system, const state_of<System, S>& mu, const wiener<S, System::channels>& w) {
  if constexpr (requires { system.drift_over(mu, w); })
    return system.drift_over(mu, w);
  else
    return S(w.dt) * system.generator(mu);
}

/// ad*_xi mu, xi = a(mu) dt + sum sigma_i dW^i: where what does not move mu may be left out of xi.
template <class System, class S>
auto motion(const System& system, const state_of<System, S>& mu, const wiener<S, System::channels>& w) {
  if constexpr (requires { system.motion_over(mu, w); })
    return system.motion_over(mu, w);
  else
    return System::algebra::coad(generator(system, mu, w), mu);
}

/// A map of the state and its derivative: slope[i] is the gradient of component i.
template <class S, int N>
struct linearised {
  vec<S, N> value;
  matrix<S, N> slope;
};

/// A vector as one of duals that do not vary.
template <class Number, class S, int N>
vec<Number, N> constant_of(const vec<S, N>& v) {
  auto out = zeros<vec<Number, N>>(v.size);
  for (int k = 0; k < v.size; ++k) out[k].value = v[k];
  return out;
}

/// A map of the state and the increment with its derivative by the state, by dual numbers; a direction at a time where
/// their number is not known to the compiler.
template <class Map, class S, int N, int M>
linearised<S, N> derivative_of(Map map, const vec<S, N>& mu, const wiener<S, M>& w) {
  constexpr int at_once = N < 0 ? 1 : N;
  using number = dual<S, at_once>;
  const wiener<number, M> increment{w.dt, constant_of<number>(w.dw)};
  linearised<S, N> out;
  if constexpr (N < 0) {
    out.slope = zeros<decltype(out.slope)>(mu.size);
    for (auto& row : out.slope) row = zeros<vec<S, N>>(mu.size);
    out.value = zeros<vec<S, N>>(mu.size);
    for (int column = 0; column < mu.size; ++column) {
      auto x = constant_of<number>(mu);
      x[column].slope[0] = S(1.0);
      const auto moved = map(x, increment);
      for (int k = 0; k < mu.size; ++k) {
        out.value[k] = moved[k].value;
        out.slope[k][column] = moved[k].slope[0];
      }
    }
  } else {
    const auto moved = map(seeded(mu), increment);
    for (int k = 0; k < N; ++k) {
      out.value[k] = moved[k].value;
      out.slope[k] = moved[k].slope;
    }
  }
  return out;
}

/// `motion` with its derivative by the state: a system's own, or by dual numbers.
template <class System, class S>
linearised<S, System::dimension> linearised_motion(const System& system, const state_of<System, S>& mu,
                                                   const wiener<S, System::channels>& w) {
  if constexpr (requires { system.linearised_motion_over(mu, w); })
    return system.linearised_motion_over(mu, w);
  else
    return derivative_of([&](const auto& x, const auto& v) { return motion(system, x, v); }, mu, w);
}

/// The noise alone, as one exponential: Ad*_exp(sum sigma_i dW^i) mu; of sigma_i that depend on the state the mean of
/// both ends, as Stratonovich's calculus asks.
template <class System, class S>
state_of<System, S> noise_flow(const System& system, const state_of<System, S>& mu,
                               const wiener<S, System::channels>& w) {
  if constexpr (requires { system.noise_flow(mu, w); }) {
    return system.noise_flow(mu, w);
  } else {
    using g = typename System::algebra;
    const auto first = noise(system, mu, w);
    if constexpr (constant_noise_system<System>)
      return g::exp_action(first, mu);
    else
      return g::exp_action(S(0.5) * (first + noise(system, g::exp_action(first, mu), w)), mu);
  }
}

/// Half the dissipation, the noise, half the dissipation.
template <class System, class S>
state_of<System, S> damped_noise_flow(const System& system, const state_of<System, S>& mu,
                                      const wiener<S, System::channels>& w) {
  if constexpr (requires { system.damped_noise_flow(mu, w); }) {
    return system.damped_noise_flow(mu, w);
  } else {
    const half_step half{w.dt};
    return system.dissipation_flow(noise_flow(system, system.dissipation_flow(mu, half), w), half);
  }
}

/// Half the last turn, the noise between its halves of the dissipation, half the last turn.
template <turning_system System, class S>
state_of<System, S> turned_noise_flow(const System& system, const state_of<System, S>& mu,
                                      const wiener<S, System::channels>& w) {
  if constexpr (requires { system.turned_noise_flow(mu, w); }) {
    return system.turned_noise_flow(mu, w);
  } else {
    const half_step half{w.dt};
    return system.last_turn(damped_noise_flow(system, system.last_turn(mu, half), w), half);
  }
}

/// ad*_xi m - s(xi, m) / 2, s the sandwich of an algebra of matrices: what the isospectral midpoint repeats.
template <class System, class S>
auto contracted_motion(const System& system, const state_of<System, S>& m, const wiener<S, System::channels>& w) {
  if constexpr (requires { system.contracted_motion_over(m, w); }) {
    return system.contracted_motion_over(m, w);
  } else {
    using g = typename System::algebra;
    const auto xi = generator(system, m, w);
    return g::coad(xi, m) - S(0.5) * g::sandwich(xi, m);
  }
}
template <class System, class S>
linearised<S, System::dimension> linearised_contracted_motion(const System& system, const state_of<System, S>& m,
                                                              const wiener<S, System::channels>& w) {
  if constexpr (requires { system.linearised_contracted_motion_over(m, w); })
    return system.linearised_contracted_motion_over(m, w);
  else
    return derivative_of([&](const auto& x, const auto& v) { return contracted_motion(system, x, v); }, m, w);
}

}  // namespace polhode
