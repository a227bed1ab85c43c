// SPDX-License-Identifier: Apache-2.0
// Coupled classical spins, each with the same anisotropy in the same field, on the dual of so(3)^N.
//
//   dS_i = S_i x (Omega_i + theta S_i x Omega_i) dt + sum_k S_i x sigma_ki o dW^k                       (Stratonovich),
//   h = sum_i (S_i.quadratic S_i / 2 + field.S_i) + sum_{i<j} J_ij S_i.S_j,   Omega_i = dh/dS_i
//
// The Casimirs are the lengths |S_i|. Signs as in spin.hpp: h is the energy, the effective field is -Omega_i. In place
// of J_ij u a pair may have any energy f_ij(u), u = S_i.S_j, that pair_energy.hpp knows: so vortices are spins too.
// Source: Brown, Phys. Rev. 130 (1963) 1677-1686; Arnaudon, De Castro, Holm, arXiv:1601.02249 (coadjoint orbits).
#pragma once

#include <Eigen/Core>
#include <array>
#include <ranges>
#include <type_traits>
#include <utility>
#include <vector>

#include <polhode/lie/so3_power.hpp>
#include <polhode/lie/so4.hpp>
#include <polhode/systems/constant_noise_sized.hpp>
#include <polhode/systems/double_bracket.hpp>
#include <polhode/systems/pair_energy.hpp>
#include <polhode/systems/spin.hpp>

namespace polhode {

inline constexpr int most_spins = 16;

/// Group: so3_power for any number of spins, known at run time alone; so4 for two, in registers.
template <class Group>
struct coupled_spins : double_bracket<coupled_spins<Group>, Group> {
  using group = Group;
  using double_bracket<coupled_spins, Group>::theta;
  template <class S>
  using state = vec<S, group::dimension>;
  static constexpr bool approximate_dissipation = true;

  /// quadratic symmetric; exchange symmetric, N x N, its diagonal is not looked at; theta >= 0; noise of 3 N
  /// components.
  coupled_spins(const Eigen::Matrix3d& quadratic, const std::array<double, 3>& field, const Eigen::MatrixXd& exchange,
                double dissipation, constant_noise<group> noise_vectors)
      : double_bracket<coupled_spins, Group>(dissipation, std::move(noise_vectors)),
        site_(quadratic, field, 0, constant_noise<so3>()),
        has_site_(!quadratic.isZero(0) || field != std::array<double, 3>{}) {
    for (int i = 0; i < exchange.rows(); ++i)
      for (int j = i + 1; j < exchange.rows(); ++j)
        if (exchange(i, j) != 0) pairs_.push_back({i, j, exchange(i, j)});
  }
  /// Nothing but pairs.
  coupled_spins(std::vector<pair_energy> pairs, double dissipation, constant_noise<group> noise_vectors)
      : double_bracket<coupled_spins, Group>(dissipation, std::move(noise_vectors)),
        site_(Eigen::Matrix3d::Zero(), {}, 0, constant_noise<so3>()),
        has_site_(false),
        pairs_(std::move(pairs)) {}

  template <class S>
  state<S> omega(const state<S>& mu) const {
    if constexpr (two)
      return gradient(mu);
    else
      return gradient_of_many(mu);
  }
  template <class S>
  S energy(const state<S>& mu) const {
    S sum(0.0);
    for (int i = 0; i < mu.size / 3; ++i) sum = sum + site_.energy(group::part(mu, i));
    for_pairs(pairs_, [&](int i, int j, const pair_energy& pair) {
      sum = sum + pair.value(group::part(mu, i), group::part(mu, j));
    });
    return sum;
  }

  /// The dissipation alone, to second order: the mean of its generators at both ends of an Euler step, as one
  /// exponential.
  template <class S>
  [[gnu::noinline]] state<S> dissipation_flow(const state<S>& mu, double t) const {
    return damped(mu, t);
  }
  /// The motion without dissipation, to second order.
  template <class S>
  [[gnu::noinline]] state<S> free_flow(const state<S>& mu, double t) const {
    return first_turn(last_turn(first_turn(mu, t / 2), t), t / 2);
  }
  /// One principal axis of each spin's own energy, exact.
  template <class S>
  [[gnu::noinline]] state<S> first_turn(const state<S>& mu, double t) const {
    return at_each_site(mu, [&](const vec<S, 3>& x) { return site_.first_turn(x, t); });
  }
  /// Half of the rest of it, the pairs, and the other half.
  template <class S>
  [[gnu::noinline]] state<S> last_turn(const state<S>& mu, double t) const {
    const auto rest = [&](const vec<S, 3>& x) { return site_.last_turn(x, t / 2); };
    auto next = at_each_site(mu, rest);
    if constexpr (two) {  // twice the same turn
      for_pairs(pairs_, [&](int i, int j, const pair_energy& pair) { turn(next, i, j, pair, t); });
    } else {
      const auto half = [&](int i, int j, const pair_energy& pair) { turn(next, i, j, pair, t / 2); };
      for_pairs(pairs_, half);
      for_pairs(pairs_ | std::views::reverse, half);
    }
    return at_each_site(next, rest);
  }

 protected:
  template <class S>
  state<S> damped(const state<S>& mu, double t) const {
    if (theta == 0) return mu;
    return averaged_flow<group>([&](const state<S>& x) { return S(theta * t) * group::coad(omega(x), x); }, mu);
  }
  const spin& site() const { return site_; }
  const std::vector<pair_energy>& pairs() const { return pairs_; }

 private:
  static constexpr bool two = std::is_same_v<Group, so4>;

  template <class S>
  state<S> gradient(const state<S>& mu) const {
    auto out = zeros<state<S>>(mu.size);
    for (int i = 0; i < mu.size / 3; ++i) group::set_part(out, i, site_.omega(group::part(mu, i)));
    for_pairs(pairs_, [&](int i, int j, const pair_energy& pair) {
      const int a = 3 * i, b = 3 * j;
      const S slope = pair.slope(group::part(mu, i), group::part(mu, j));
      for (int k = 0; k < 3; ++k) {
        out[a + k] = out[a + k] + slope * mu[b + k];
        out[b + k] = out[b + k] + slope * mu[a + k];
      }
    });
    return out;
  }
  template <class S>
  [[gnu::noinline]] state<S> gradient_of_many(const state<S>& mu) const {
    return gradient(mu);
  }

  /// f(i, j, pair), the places of two spins known to the compiler.
  template <class Pairs, class F>
  static void for_pairs(const Pairs& pairs, F f) {
    for (const auto& pair : pairs)
      if constexpr (two)
        f(0, 1, pair);
      else
        f(pair.i, pair.j, pair);
  }

  template <class S, class Flow>
  state<S> at_each_site(state<S> mu, Flow flow) const {
    if (!has_site_) return mu;
    for (int i = 0; i < mu.size / 3; ++i) group::set_part(mu, i, flow(group::part(mu, i)));
    return mu;
  }
  /// One pair alone, exact: S_i.S_j and the sum of both stay, and both turn about it.
  template <class S>
  static void turn(state<S>& mu, int i, int j, const pair_energy& pair, double t) {
    const auto a = group::part(mu, i), b = group::part(mu, j);
    const auto gained = gained_about_sum(S(S(t) * pair.slope(a, b)), a, b);
    group::set_part(mu, i, a + gained);
    group::set_part(mu, j, b - gained);
  }

  spin site_;
  bool has_site_;
  std::vector<pair_energy> pairs_;
};

using spins = coupled_spins<so3_power<most_spins>>;
using spin_pair = coupled_spins<so4>;

}  // namespace polhode
