// SPDX-License-Identifier: Apache-2.0
// The rigid body in n dimensions, n from 3 to 6, on the dual of so(n).
//
//   dmu = ad*_{a(mu)} mu dt + sum_i ad*_{sigma_i} mu o dW^i,   a(mu) = Omega + theta ad*_Omega mu,
//   h = 1/2 sum_{i<j} M_ij^2 / (lambda_i + lambda_j),   Omega_ij = M_ij / (lambda_i + lambda_j)         (Stratonovich)
//
// lambda_i: moments of the mass along the axes, so lambda_i + lambda_j is the inertia in the plane (i, j). Source:
// Manakov, Funct. Anal. Appl. 10 (1976) 328-329; Ratiu, Indiana Univ. Math. J. 29 (1980) 609-629; dissipation and
// noise: Arnaudon, De Castro, Holm, arXiv:1601.02249.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include <polhode/lie/son.hpp>
#include <polhode/systems/constant_noise_sized.hpp>
#include <polhode/systems/double_bracket.hpp>

namespace polhode {

struct son_body : double_bracket<son_body, son> {
  template <class S>
  using state = vec<S, son::dimension>;
  static constexpr bool approximate_dissipation = true;

  /// n numbers with lambda_i + lambda_j > 0, theta >= 0; noise of n (n - 1) / 2 components.
  son_body(const std::vector<double>& lambda, double dissipation, constant_noise<son> noise_vectors)
      : double_bracket(dissipation, std::move(noise_vectors)), rows(static_cast<int>(lambda.size())) {
    inverse_inertia = vec<double, son::dimension>(rows * (rows - 1) / 2);
    int place = 0;
    for (int i = 0; i < rows; ++i)
      for (int j = i + 1; j < rows; ++j)
        inverse_inertia[place++] = 1 / (lambda[static_cast<std::size_t>(i)] + lambda[static_cast<std::size_t>(j)]);
  }

  int rows;
  vec<double, son::dimension> inverse_inertia;

  template <class S>
  state<S> omega(const state<S>& mu) const {
    return scaled(inverse_inertia, mu);
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
    return averaged_flow<son>([&](const state<S>& x) { return S(theta * t) * son::coad(omega(x), x); }, mu);
  }
  /// The motion without dissipation, to second order: a palindrome of the turns in all planes, each the exact flow of
  /// its part of h.
  template <class S>
  [[gnu::noinline]] state<S> free_flow(const state<S>& mu, double t) const {
    return first_turn(last_turn(first_turn(mu, t / 2), t), t / 2);
  }
  /// The turn in the plane (1, 2), exact.
  template <class S>
  [[gnu::noinline]] state<S> first_turn(const state<S>& mu, double t) const {
    auto added = zeros<state<S>>(mu.size);
    turn(mu, added, 0, 1, t);
    return mu + added;
  }
  /// The turns in all other planes.
  template <class S>
  [[gnu::noinline]] state<S> last_turn(const state<S>& mu, double t) const {
    auto added = zeros<state<S>>(mu.size);
    for (int i = 0; i < rows; ++i)
      for (int j = std::max(i + 1, 2); j < rows; ++j) turn(mu, added, i, j, t / 2);
    for (int i = rows - 1; i >= 0; --i)
      for (int j = rows - 1; j >= std::max(i + 1, 2); --j) turn(mu, added, i, j, t / 2);
    return mu + added;
  }

 private:
  /// The flow of M_ij^2 / 2 (lambda_i + lambda_j) from mu + added: M_ij stays, the rows i and j of M turn at its rate.
  /// What turns add is summed apart from mu, so that each rounds to the size of what it adds; a rounded cosine would
  /// shrink all entries alike.
  template <class S>
  void turn(const state<S>& mu, state<S>& added, int i, int j, double t) const {
    const int own = son::place(rows, i, j);
    const auto [half_sin, half_cos] = sincos(S(S(t / 2 * inverse_inertia[own]) * (mu[own] + added[own])));
    const S sin = S(2.0) * half_sin * half_cos, less = S(2.0) * half_sin * half_sin;  // 1 - cos
    for (int k = 0; k < rows; ++k) {
      if (k == i || k == j) continue;
      const S a = entry(mu, i, k) + entry(added, i, k), b = entry(mu, j, k) + entry(added, j, k);
      add_to_entry(added, i, k, S(-(less * a + sin * b)));
      add_to_entry(added, j, k, S(sin * a - less * b));
    }
  }
  template <class S>
  S entry(const state<S>& mu, int i, int j) const {
    return i < j ? mu[son::place(rows, i, j)] : S(-mu[son::place(rows, j, i)]);
  }
  template <class S>
  void add_to_entry(state<S>& mu, int i, int j, const S& x) const {
    auto& here = mu[i < j ? son::place(rows, i, j) : son::place(rows, j, i)];
    here = i < j ? S(here + x) : S(here - x);
  }
};

}  // namespace polhode
