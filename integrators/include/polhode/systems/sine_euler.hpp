// SPDX-License-Identifier: Apache-2.0
// Zeitlin's truncation of Euler's equation of an ideal fluid on the torus, the sine-Euler equation, on the dual of
// su(n).
//
//   dw_m/dt = -n / 2 pi sum_k sin(2 pi (k x m) / n) w_k w_{m-k} / |k|^2              (without dissipation and noise),
//   h = 1/2 sum_k |w_k|^2 / |k|^2
//
// w(x) = sum_k w_k exp(i k.x) is the vorticity, -w_k / |k|^2 the stream function, h the kinetic energy per area;
// indices are taken mod n, to -(n - 1)/2 … (n - 1)/2. The state has their real and imaginary parts (lie/su.hpp), and
// the equation is dmu = ad*_{dh/dmu} mu. Casimirs: tr W^j, j = 2 … n, in place of the integrals of w^j. Dissipation
// takes energy and keeps the Casimirs. Source: Zeitlin, Physica D 49 (1991) 353-362; splitting: McLachlan, Phys. Rev.
// Lett. 71 (1993) 3043-3046.
#pragma once

#include <cstddef>
#include <numbers>
#include <utility>

#include <polhode/lie/complex_matrix.hpp>
#include <polhode/lie/su.hpp>
#include <polhode/scalar.hpp>
#include <polhode/systems/constant_noise_sized.hpp>
#include <polhode/systems/double_bracket.hpp>

namespace polhode {

struct sine_euler : double_bracket<sine_euler, su> {
  template <class S>
  using state = vec<S, su::dimension>;
  static constexpr bool approximate_dissipation = true;

  /// n = 3 or 5, theta >= 0; noise of n^2 - 1 components.
  sine_euler(int n, double dissipation, constant_noise<su> noise_vectors)
      : double_bracket(dissipation, std::move(noise_vectors)), rows(n), inverse_square(n * n - 1) {
    su::for_each_mode(n, [&](int place, int k1, int k2) {
      inverse_square[place] = inverse_square[place + 1] = 1.0 / (k1 * k1 + k2 * k2);
    });
  }

  int rows;
  vec<double, su::dimension> inverse_square;  ///< 1 / |k|^2

  template <class S>
  state<S> omega(const state<S>& mu) const {
    return scaled(inverse_square, mu);
  }
  template <class S>
  S energy(const state<S>& mu) const {
    return S(0.5) * dot(mu, omega(mu));
  }

  /// The dissipation alone, to second order: the mean of its generators at both ends of an Euler step, as one
  /// exponential.
  template <class S>
  POLHODE_CALLED state<S> dissipation_flow(const state<S>& mu, double t) const {
    if (theta == 0) return mu;
    return averaged_flow<su>([&](const state<S>& x) { return S(theta * t) * su::coad(omega(x), x); }, mu);
  }
  /// The motion without dissipation, to second order: a palindrome of the flows of all lines, each exact.
  template <class S>
  POLHODE_CALLED state<S> free_flow(const state<S>& mu, double t) const {
    return first_turn(last_turn(first_turn(mu, t / 2), t), t / 2);
  }
  template <class S>
  POLHODE_CALLED state<S> first_turn(const state<S>& mu, double t) const {
    return line_turn(mu, 0, t);
  }
  template <class S>
  POLHODE_CALLED state<S> last_turn(state<S> mu, double t) const {
    for (int i = 1; i < rows; ++i) mu = line_turn(mu, i, t / 2);
    mu = line_turn(mu, rows, t);
    for (int i = rows - 1; i >= 1; --i) mu = line_turn(mu, i, t / 2);
    return mu;
  }

  /// The flow of the part of h of the modes on one line, k = a d mod n, d = (1, which) or, last, (0, 1). They stay;
  /// with s = m x d the modes m + j d, j = 0 … n - 1, are convolved with n / 2 pi sin(2 pi a s / n) w_{a d} / |a d|^2,
  /// and so their Fourier transforms turn at rates of their own. What it adds is computed: rounding takes no side.
  template <class S>
  POLHODE_CALLED state<S> line_turn(const state<S>& mu, int which, double t) const {
    return su::at_size(mu.size, [&](auto n) { return turned<n>(mu, which, t); });
  }

  template <int n, class S>
  state<S> turned(const state<S>& mu, int which, double t) const {
    using number = complex_number<S>;
    const int d1 = which < n ? 1 : 0, d2 = which < n ? which : 1;
    const auto& on = su::circle_of(n);
    const auto at = [](int k1, int k2) { return static_cast<std::size_t>(n * ((k1 + n * n) % n) + (k2 + n * n) % n); };
    const auto w = su::modes<n>(mu), flow = su::modes<n>(omega(mu));
    auto added = su::modes<n>(state<S>(mu.size));
    for (int s = 1; s <= n / 2; ++s) {
      const int m1 = d1 == 0 ? s : 0, m2 = d1 == 0 ? 0 : -s;
      for (int q = 0; q < n; ++q) {
        S rate(0.0);
        number transform;
        for (int a = 1; a <= n / 2; ++a)
          rate = rate + S(n / std::numbers::pi * on.at[a * s % n].imaginary) *
                            times_constant(conjugate(on.at[a * q % n]), flow[at(a * d1, a * d2)]).imaginary;
        for (int j = 0; j < n; ++j)
          transform = transform + times_constant(conjugate(on.at[j * q % n]), w[at(m1 + j * d1, m2 + j * d2)]);
        const auto [sin, cos] = sincos(S(S(t / 2) * rate));
        const number change = S(S(2.0 / n) * sin) * (number{-sin, cos} * transform);
        for (int j = 0; j < n; ++j) {
          auto& sum = added[at(m1 + j * d1, m2 + j * d2)];
          sum = sum + times_constant(on.at[j * q % n], change);
        }
      }
      for (int j = 0; j < n; ++j)
        added[at(-m1 - j * d1, -m2 - j * d2)] = conjugate(added[at(m1 + j * d1, m2 + j * d2)]);
    }
    auto out = mu;
    su::for_each_mode(n, [&](int place, int k1, int k2) {
      out[place] = out[place] + S(std::numbers::sqrt2) * added[at(k1, k2)].real;
      out[place + 1] = out[place + 1] + S(std::numbers::sqrt2) * added[at(k1, k2)].imaginary;
    });
    return out;
  }
};

}  // namespace polhode
