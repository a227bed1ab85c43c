// SPDX-License-Identifier: Apache-2.0
// The rigid body bound to a step size and an orbit: the same mathematics as polhode/systems/rigid_body.hpp, with
// everything that does not change from step to step computed once, absent parts absent, and no division in the step.
// Over 200 lines, as it is one class: all flows of a step read the constants of one step size and orbit.
// For states on the orbit |Pi| = c for which it was made; others are integrated with this orbit's dissipation factors.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <polhode/chebyshev.hpp>
#include <polhode/systems/lie_poisson.hpp>
#include "ensemble/noise_at.hpp"
#include "systems/rigid_body/motion/body_parts.hpp"
#include "systems/rigid_body/motion/rigid_body_constants.hpp"

namespace polhode {

/// parts, size: systems/rigid_body/motion/body_parts.hpp; Noise: ensemble/noise_at.hpp.
template <body_parts parts, rotation_size size, class Noise>
class rigid_body_at : public Noise {
 public:
  using algebra = typename rotations<size>::algebra;
  static constexpr int dimension = 3, channels = 3;
  static constexpr bool polynomials = parts.dissipation && size != rotation_size::any;
  static constexpr int norm_degree = [] {
    if constexpr (polynomials) return rotations<size>::norm_degree;
    return 0;
  }();

  rigid_body_at(const rigid_body_constants& constants, const Noise& noise)
      : rigid_body_at(constants, normalisation<norm_degree>(constants), noise) {}
  /// norm: c / |y| by the excess of |y|^2 over 1.
  rigid_body_at(const rigid_body_constants& constants, const polynomial<norm_degree>& norm, const Noise& noise)
      : Noise(noise), k_(constants), norm_(norm) {}

  template <int degree>
  static polynomial<degree> normalisation(const rigid_body_constants& k) {
    if constexpr (!polynomials)
      return {};
    else
      return chebyshev_interpolation<degree>([&](long double e) { return k.radius / std::sqrt(1 + e); },
                                             std::max(k.spread(), 1e-300));
  }

  /// The same body with other noise: with that of one step which all paths share, say.
  template <class Other>
  auto with(const Other& noise) const {
    return rigid_body_at<parts, size, Other>(k_, norm_, noise);
  }

  /// What all paths share of a step with sum sigma_i dW^i = b and sum A^ij [sigma_i, sigma_j] = area.
  shared_step share(const vec<double, 3>& b, const vec<double, 3>& area) const {
    shared_step out{b, area, {}, {}};
    for (int j = 0; j < 3; ++j) {
      vec<double, 3> e{};
      e[j] = 1;
      const auto turned = so3::exp_action(b, e), before = damped(e, half_step{});
      const auto after = damped_to_unit(so3::exp_action(b, before), half_step{});
      for (int i = 0; i < 3; ++i) {
        out.rotation[static_cast<std::size_t>(i)][j] = turned[i];
        out.damped[static_cast<std::size_t>(i)][j] = after[i];
      }
    }
    return out;
  }

  template <class S>
  vec<S, 3> generator(const vec<S, 3>& pi) const {
    const auto w = scaled(k_.inverse_inertia, pi);
    if constexpr (parts.dissipation) return w + S(k_.theta) * cross(pi, w);
    return w;
  }

  template <class S>
  vec<S, 3> drift_over(const vec<S, 3>& pi, const wiener<S, 3>&) const {
    return driven(pi, zero_vector{});
  }
  template <class S>
  vec<S, 3> generator_over(const vec<S, 3>& pi, const wiener<S, 3>& w) const {
    return driven(pi, this->noise(w.dw));
  }
  /// Pi x xi, xi without the multiple of Pi by which the Casimir shift differs from a(Pi) dt + B.
  template <class S>
  auto motion_over(const vec<S, 3>& pi, const wiener<S, 3>& w) const {
    return algebra::coad(shifted_generator(pi, w), pi);
  }
  template <class S>
  linearised<S, 3> linearised_motion_over(const vec<S, 3>& pi, const wiener<S, 3>& w) const {
    const auto xi = shifted_generator(pi, w);
    const S first(k_.shifted[0]), last(k_.shifted[2]);
    matrix<S, 3> slope{{vec<S, 3>{{S(0.0), xi[2], last * pi[1] - xi[1]}},
                        vec<S, 3>{{first * pi[2] - xi[2], S(0.0), xi[0] - last * pi[0]}},
                        vec<S, 3>{{xi[1] - first * pi[1], -xi[0], S(0.0)}}}};
    if constexpr (parts.dissipation) {
      // Of the dissipating part of xi, theta dt (Pi_2 Omega_3, gamma_2 / theta dt Pi_3 Pi_1, -Pi_2 Omega_1), shifted.
      const S theta_pi = S(k_.theta) * pi[1], bend(k_.gamma[1]);
      const S a = S(k_.theta) * (first * pi[0]), b = S(k_.theta) * (last * pi[2]);
      const S c = first * theta_pi, d = last * theta_pi;
      slope[0] = slope[0] + vec<S, 3>{{-(pi[1] * c) - bend * (pi[2] * pi[2]), -(pi[1] * a), -(bend * (pi[2] * pi[0]))}};
      slope[1] = slope[1] + vec<S, 3>{{pi[0] * c, pi[2] * b + pi[0] * a, pi[2] * d}};
      slope[2] = slope[2] + vec<S, 3>{{bend * (pi[0] * pi[2]), -(pi[1] * b), bend * (pi[0] * pi[0]) - pi[1] * d}};
    }
    return {cross(pi, xi), slope};
  }

  template <class S>
  vec<S, 3> noise_flow(const vec<S, 3>& pi, const wiener<S, 3>& w) const {
    if constexpr (Noise::shared)
      return times(this->step.rotation, pi);
    else
      return algebra::exp_action(this->noise(w.dw), pi);
  }

  /// Both normalisations at the end: the rotation between them is linear and keeps lengths.
  template <class S>
  vec<S, 3> damped_noise_flow(const vec<S, 3>& pi, const wiener<S, 3>& w) const {
    if constexpr (!parts.dissipation) return noise_flow(pi, w);
    if constexpr (Noise::shared) return normalised(times(this->step.damped, pi));
    return normalised(damped_to_unit(noise_flow(damped(pi, half_step{}), w), half_step{}));
  }

  template <class S, int n>
  vec<S, 3> dissipation_flow(const vec<S, 3>& pi, part_of_step<n> t) const {
    if constexpr (!parts.dissipation) return pi;
    return normalised(damped_to_unit(pi, t));
  }

  template <class S, int n>
  vec<S, 3> free_flow(vec<S, 3> pi, part_of_step<n>) const {
    if constexpr (!parts.first_turn && !parts.last_turn) return pi;
    pi = turn<1>(turn<0>(pi, k_.kappa[0] / (2 * n)), k_.kappa[1] / (2 * n));
    pi = turn<2>(pi, k_.kappa[2] / n);
    return turn<0>(turn<1>(pi, k_.kappa[1] / (2 * n)), k_.kappa[0] / (2 * n));
  }
  template <class S, int n>
  vec<S, 3> first_turn(const vec<S, 3>& pi, part_of_step<n>) const {
    constexpr int axis = parts.last_turn ? 0 : 2;
    if constexpr (!parts.first_turn)
      return pi;
    else if constexpr (size == rotation_size::tiny)
      return k_.first_turns[n - 1][axis].template about<axis>(pi);
    else
      return turn<axis>(pi, k_.shifted[axis] / n);
  }
  template <class S, int n>
  vec<S, 3> last_turn(const vec<S, 3>& pi, part_of_step<n>) const {
    if constexpr (!parts.last_turn)
      return pi;
    else if constexpr (size == rotation_size::tiny && n == 2)
      return k_.last_half_turn.template about<2>(pi);
    else
      return turn<2>(pi, k_.shifted[2] / n);
  }

  double energy(const vec<double, 3>& pi) const { return 0.5 * dot(pi, scaled(k_.inverse_inertia, pi)); }

 private:
  template <class S>
  static S value_of(const S& x) {
    return x;
  }
  template <class S>
  static S value_of(zero) {
    return S(0.0);
  }
  /// The component k of theta dt Pi x Omega, or the zero that leaves it out.
  template <class S>
  auto dissipating(int k, const vec<S, 3>& pi) const {
    if constexpr (parts.dissipation)
      return S((S(k_.gamma[k]) * pi[(k + 1) % 3]) * pi[(k + 2) % 3]);
    else
      return zero{};
  }

  template <class S>
  vec<S, 3> shifted_generator(const vec<S, 3>& pi, const wiener<S, 3>& w) const {
    const auto b = this->noise(w.dw);
    const S first = S(k_.shifted[0]) * pi[0], last = S(k_.shifted[2]) * pi[2];
    vec<S, 3> xi{{b[0] + first, value_of<S>(b[1] + dissipating(1, pi)), b[2] + last}};
    if constexpr (parts.dissipation) {
      const S theta_pi = S(k_.theta) * pi[1];
      xi[0] = xi[0] + theta_pi * last;
      xi[2] = xi[2] - theta_pi * first;
    }
    return xi;
  }

  /// a(Pi) dt + b, each component one chain of fused products.
  template <class S, class B>
  vec<S, 3> driven(const vec<S, 3>& pi, const B& b) const {
    vec<S, 3> out;
    for (int k = 0; k < 3; ++k) out[k] = b[k] + S(k_.kappa[k]) * pi[k] + dissipating(k, pi);
    return out;
  }

  template <class S, int n>
  vec<S, 3> damped(const vec<S, 3>& pi, part_of_step<n>) const {
    const auto& factor = k_.damping[n - 1];
    vec<S, 3> out;
    for (int k = 0; k < 3; ++k) out[k] = k == 1 && polynomials ? pi[k] : S(S(factor[k]) * pi[k]);
    return out;
  }

  template <class S, int n>
  vec<S, 3> damped_to_unit(const vec<S, 3>& pi, part_of_step<n>) const {
    return scaled(k_.damping_to_unit[n - 1], pi);
  }

  /// c y / |y| of a y damped to unit: no power of |Pi| in a coefficient.
  template <class S>
  vec<S, 3> normalised(const vec<S, 3>& y) const {
    if constexpr (polynomials) {
      const S excess = y[2] * y[2] + (y[1] * y[1] + (y[0] * y[0] - S(1.0)));
      return evaluate(norm_, excess) * y;
    } else {
      return S(S(k_.radius) / square_root(dot(y, y))) * y;
    }
  }

  template <class S>
  static vec<S, 3> times(const std::array<vec<double, 3>, 3>& m, const vec<S, 3>& x) {
    vec<S, 3> out;
    for (int k = 0; k < 3; ++k) {
      const auto& row = m[static_cast<std::size_t>(k)];
      out[k] = S(row[0]) * x[0] + (S(row[1]) * x[1] + S(row[2]) * x[2]);
    }
    return out;
  }

  template <int axis, class S>
  static vec<S, 3> turn(const vec<S, 3>& pi, double t) {
    constexpr int next = (axis + 1) % 3, last = (axis + 2) % 3;
    const S angle = S(t) * pi[axis];
    S sin, cos;
    if constexpr (size == rotation_size::any) {
      const auto both = sincos(angle);
      sin = both.sin;
      cos = both.cos;
    } else {
      static constexpr double reach = rotations<size>::bounds.turn;
      static constexpr auto sinc = cosine_polynomial<rotations<size>::sine_degree>(1, reach * reach);
      static constexpr auto cosc = cosine_polynomial<rotations<size>::cosine_degree>(2, reach * reach);
      const S q = angle * angle;
      sin = angle * evaluate(sinc, q);
      cos = S(1.0) - q * evaluate(cosc, q);  // exact at 0: a rounded first coefficient would shrink every turn alike
    }
    vec<S, 3> out;
    out[axis] = pi[axis];
    out[next] = pi[next] * cos + pi[last] * sin;
    out[last] = pi[last] * cos - pi[next] * sin;
    return out;
  }

  rigid_body_constants k_;
  polynomial<norm_degree> norm_{};
};

}  // namespace polhode
