// SPDX-License-Identifier: Apache-2.0
// Two spins with an easy axis or plane along an axis, bound to a step size: the same flows as
// polhode/systems/spins.hpp, inlined into the step, and the turn about the field as a matrix.
#pragma once

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <polhode/systems/spins.hpp>

namespace polhode {

struct spin_pair_at : spin_pair {
  spin_pair_at(spin_pair pair, const std::vector<double>&, double dt)
      : spin_pair(std::move(pair)), axis_(std::max(site().principal().odd_axis(), 0)) {
    const auto& lambda = site().principal().lambda;
    excess_ = lambda[axis_] - lambda[(axis_ + 1) % 3];
    exchange_ = pairs().empty() ? 0 : pairs()[0].strength;
    for (int n = 1; n <= 2; ++n)
      for (int k = 0; k < 3; ++k) {
        vec<double, 3> e{};
        e[k] = 1;
        const auto turned = so3::exp_action((dt / (2 * n)) * site().field, e) - e;
        for (int i = 0; i < 3; ++i) about_field_[static_cast<std::size_t>(n - 1)][i][k] = turned[i];
      }
  }

  /// Whether there is one axis, and the bond is one of exchange.
  bool fits() const {
    return site().diagonal() && site().principal().odd_axis() >= 0 && (pairs().empty() || pairs()[0].is_exchange());
  }

  template <class S>
  vec<S, 6> dissipation_flow(const vec<S, 6>& mu, double t) const {
    return damped(mu, t);
  }
  template <class S>
  vec<S, 6> first_turn(const vec<S, 6>& mu, double t) const {
    return axis_ == 0 ? about<0>(mu, t) : axis_ == 1 ? about<1>(mu, t) : about<2>(mu, t);
  }
  template <class S, int n>
  vec<S, 6> last_turn(const vec<S, 6>& mu, part_of_step<n> t) const {
    const auto& change = about_field_[n - 1];
    const auto a = changed(change, so4::part(mu, 0)), b = changed(change, so4::part(mu, 1));
    const auto gained = gained_about_sum(S(t * exchange_), a, b);
    // What the matrix rounds alike step after step would let the lengths drift.
    return so4::orbit_projection(so4::joined(changed(change, a + gained), changed(change, b - gained)), mu);
  }

 private:
  template <int axis, class S>
  vec<S, 6> about(vec<S, 6> mu, double t) const {
    constexpr int next = (axis + 1) % 3, last = (axis + 2) % 3;
    for (const int part : {0, 3}) {
      const auto [sin, cos] = sincos(S(S(t * excess_) * mu[part + axis]));
      const S a = mu[part + next], b = mu[part + last];
      mu[part + next] = a * cos + b * sin;
      mu[part + last] = b * cos - a * sin;
    }
    return mu;
  }

  using rows = vec<vec<double, 3>, 3>;
  template <class S>
  static vec<S, 3> changed(const rows& change, const vec<S, 3>& x) {
    auto out = x;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) out[i] = out[i] + S(change[i][k]) * x[k];
    return out;
  }

  int axis_;
  double excess_ = 0, exchange_ = 0;
  std::array<rows, 2> about_field_{};  ///< less one, over half of the step and a quarter
};

}  // namespace polhode
