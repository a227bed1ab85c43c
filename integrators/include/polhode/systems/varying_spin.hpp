// SPDX-License-Identifier: Apache-2.0
// A spin, gyrostat or body whose noise depends on the state.
//
//   dPi = Pi x (Omega + theta Pi x Omega) dt + sum_i Pi x sigma_i(Pi) o dW^i                            (Stratonovich)
//   damped:     sigma_i(Pi) = v_i + theta Pi x v_i, noise of the field that stands inside the damping, too
//   quadratic:  sigma_i(Pi) = v_i (v_i.Pi)/|v_i| = grad (v_i.Pi)^2 / (2 |v_i|); v_i = s_i e_i: a random inertia
//
// Still a coadjoint motion at every instant: |Pi| is kept. Isotropic damped noise of strength s has the law of constant
// noise of strength s sqrt(1 + theta^2 |Pi|^2), but other paths. Sources: Brown, Phys. Rev. 130 (1963) 1677-1686
// (damped); Brehier, Cohen, Jahnke, Math. Comp. 92 (2023); Luesink, Ephrati, Cifani, Geurts, arXiv:2111.13143
// (quadratic).
#pragma once

#include <utility>

#include <polhode/called.hpp>
#include <polhode/systems/spin.hpp>

namespace polhode {

enum class state_noise { damped, quadratic };

struct varying_spin : spin {
  /// The noise vectors of `body` are the v_i.
  varying_spin(spin body, state_noise form) : spin(std::move(body)), form_(form) {
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) v_[i][k] = sigma()(k, i);
    for (int i = 0; i < 3; ++i) {
      length_[i] = square_root(dot(v_[i], v_[i]));
      if (length_[i] > 0) unit_[i] = (1 / length_[i]) * v_[i];
    }
  }

  // What rests on constant vectors.
  template <class S>
  void noise(const vec<S, 3>&) const = delete;
  template <class S>
  void area_noise(const vec<S, 3>&) const = delete;
  void weak_order_two(double) const = delete;
  void with_noise(const constant_noise<so3>&) const = delete;

  /// Fields of parallel v_i commute, as one vector does.
  noise_class classify() const {
    const auto kind = constant_noise::classify();
    return kind == noise_class::none || kind == noise_class::one_vector ? kind : noise_class::state_dependent;
  }

  /// sum sigma_i(pi) dW^i.
  template <class S>
  vec<S, 3> noise_at(const vec<S, 3>& pi, const wiener<S, 3>& w) const {
    return combined(w.dw, [&](int i) { return vector_at(i, pi); });
  }
  /// sum D sigma_i [by] dW^i.
  template <class S>
  vec<S, 3> noise_slope_at(const vec<S, 3>&, const wiener<S, 3>& w, const vec<S, 3>& by) const {
    return combined(w.dw, [&](int i) { return change(i, by); });
  }
  /// sum_{i<j} A^ij ([sigma_i, sigma_j] + D sigma_j [V_i] - D sigma_i [V_j]), V_i = ad*_{sigma_i} pi.
  template <class S>
  vec<S, 3> area_noise_at(const vec<S, 3>& pi, const vec<S, 3>& area) const {
    vec<S, 3> sum{};
    int pair = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = i + 1; j < 3; ++j, ++pair) {
        const auto a = vector_at(i, pi), b = vector_at(j, pi);
        sum = sum + area[pair] * (so3::bracket(a, b) + change(j, so3::coad(a, pi)) - change(i, so3::coad(b, pi)));
      }
    return sum;
  }
  /// 1/2 sum DV_i [V_i].
  template <class S>
  vec<S, 3> ito_drift(const vec<S, 3>& pi) const {
    vec<S, 3> sum{};
    for (int i = 0; i < 3; ++i) {
      const auto a = vector_at(i, pi), v = so3::coad(a, pi);
      sum = sum + so3::coad(a, v) + so3::coad(change(i, v), pi);
    }
    return S(0.5) * sum;
  }

  /// The flow of every V_i for its dW^i, each exact, in a palindrome: in one order alone the brackets of the V_i would
  /// add areas of the size of those that are left out.
  template <class S>
  POLHODE_CALLED vec<S, 3> noise_flow(const vec<S, 3>& pi, const wiener<S, 3>& w) const {
    const int last = active_channels() - 1;
    if (last < 0) return pi;
    const auto share = [&](int i) { return i == last ? w.dw[i] : S(S(0.5) * w.dw[i]); };
    if (form_ == state_noise::quadratic)
      return so3::orbit_projection(
          palindrome(pi, last, [&](int i, const vec<S, 3>& x) { return turned_by_itself(i, x, share(i)); }), pi);
    const S length = square_root(dot(pi, pi));
    vec<spiral<S>, 3> spirals;
    for (int i = 0; i <= last; ++i) spirals[i] = spiral_of(i, share(i), length);
    const auto wind = [&](int i, const direction_of<S>& x) { return wound(i, x, spirals[i]); };
    return so3::orbit_projection(of_length(length, palindrome(direction_of<S>{length, pi}, last, wind)), pi);
  }

 private:
  /// What a flow of damped noise does wherever it starts: the sine and cosine of its angle, the root of its boost.
  template <class S>
  struct spiral {
    S sin, cos, root;
  };
  template <class S>
  spiral<S> spiral_of(int i, const S& t, const S& length) const {
    const S angle = S(length_[i]) * t;
    const auto [sin, cos] = sincos(angle);
    const S root = exponential(S(S(-theta) * angle * length));
    return {sin, cos, root};
  }

  /// flow(i, pi): that of V_i, for the share of dW^i that it has there.
  template <class State, class Flow>
  static State palindrome(State next, int last, Flow flow) {
    for (int i = 0; i < last; ++i) next = flow(i, next);
    for (int i = last; i >= 0; --i) next = flow(i, next);
    return next;
  }
  /// Of damped noise: the turn about v_i and the approach to it at once, as they commute.
  template <class S>
  direction_of<S> wound(int i, const direction_of<S>& d, const spiral<S>& by) const {
    const auto e = lifted<S>(unit_[i]);
    const S along = dot(d.part, e);
    const auto turned = along * e + (by.cos * (d.part - along * e) + by.sin * cross(d.part, e));
    return boosted({d.length, turned}, e, by.root);
  }
  /// Of quadratic noise for a time t: the turn about v_i by an angle that it keeps.
  template <class S>
  vec<S, 3> turned_by_itself(int i, const vec<S, 3>& pi, const S& t) const {
    const auto e = lifted<S>(unit_[i]);
    const S along = dot(pi, e);
    const auto [sin, cos] = sincos(S(S(length_[i]) * t * along));
    return along * e + (cos * (pi - along * e) + sin * cross(pi, e));
  }
  template <class S, class Vector>
  static vec<S, 3> combined(const vec<S, 3>& by, Vector vector) {
    return by[0] * vector(0) + by[1] * vector(1) + by[2] * vector(2);
  }
  /// sigma_i(pi).
  template <class S>
  vec<S, 3> vector_at(int i, const vec<S, 3>& pi) const {
    return form_ == state_noise::damped ? lifted<S>(v_[i]) + change(i, pi) : change(i, pi);
  }
  /// D sigma_i [by].
  template <class S>
  vec<S, 3> change(int i, const vec<S, 3>& by) const {
    const auto v = lifted<S>(v_[i]);
    if (form_ == state_noise::damped) return S(theta) * cross(by, v);
    return S(length_[i] > 0 ? 1 / length_[i] : 0.0) * (dot(v, by) * v);
  }

  state_noise form_;
  vec<vec<double, 3>, 3> v_{}, unit_{};
  vec<double, 3> length_{};
};

}  // namespace polhode
