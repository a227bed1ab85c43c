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

#include <utility>

#include <polhode/lie/su.hpp>
#include <polhode/systems/constant_noise_sized.hpp>
#include <polhode/systems/double_bracket.hpp>

namespace polhode {

struct sine_euler : double_bracket<sine_euler, su> {
  template <class S>
  using state = vec<S, su::dimension>;
  static constexpr bool approximate_dissipation = true;

  /// n = 3, 5 or 7, theta >= 0; noise of n^2 - 1 components.
  sine_euler(int n, double dissipation, constant_noise<su> noise_vectors)
      : double_bracket(dissipation, std::move(noise_vectors)), rows(n), inverse_square(n * n - 1), line(n * n - 1) {
    su::for_each_mode(n, [&](int place, int k1, int k2) {
      for (const int part : {place, place + 1}) {
        inverse_square[part] = 1.0 / (k1 * k1 + k2 * k2);
        line[part] = line_of(k1, k2);
      }
    });
  }

  int rows;
  vec<double, su::dimension> inverse_square;  ///< 1 / |k|^2
  vec<int, su::dimension> line;               ///< 0 … n: that through 0 on which k lies, mod n

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
  [[gnu::noinline]] state<S> dissipation_flow(const state<S>& mu, double t) const {
    if (theta == 0) return mu;
    return averaged_flow<su>([&](const state<S>& x) { return S(theta * t) * su::coad(omega(x), x); }, mu);
  }
  /// The motion without dissipation, to second order: a palindrome of the flows of all lines, each exact.
  template <class S>
  [[gnu::noinline]] state<S> free_flow(const state<S>& mu, double t) const {
    return first_turn(last_turn(first_turn(mu, t / 2), t), t / 2);
  }
  template <class S>
  [[gnu::noinline]] state<S> first_turn(const state<S>& mu, double t) const {
    return turn(mu, 0, t);
  }
  template <class S>
  [[gnu::noinline]] state<S> last_turn(state<S> mu, double t) const {
    for (int i = 1; i < rows; ++i) mu = turn(mu, i, t / 2);
    mu = turn(mu, rows, t);
    for (int i = rows - 1; i >= 1; --i) mu = turn(mu, i, t / 2);
    return mu;
  }

 private:
  /// k = j (1, i) mod n, or k_1 = 0.
  int line_of(int k1, int k2) const {
    if (k1 == 0) return rows;
    int i = 0;
    while ((k2 - i * k1) % rows != 0) ++i;
    return i;
  }
  /// The part of h of the modes on one line, which stay: the others move by one element of the algebra.
  template <class S>
  state<S> turn(const state<S>& mu, int which, double t) const {
    auto xi = S(t) * omega(mu);
    for (int k = 0; k < xi.size; ++k)
      if (line[k] != which) xi[k] = S(0.0);
    return su::exp_action(xi, mu);
  }
};

}  // namespace polhode
