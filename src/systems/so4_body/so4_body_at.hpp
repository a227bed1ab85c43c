// SPDX-License-Identifier: Apache-2.0
// The pair of bodies bound to a step size and an orbit: the same flows as polhode/systems/so4_body.hpp, but the
// dissipation without exponentials, divisions and roots. The lengths of both parts are the orbit's.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <polhode/chebyshev.hpp>
#include <polhode/systems/so4_body.hpp>

namespace polhode {

/// Of one part y of the pair after a linear map of both: c y / |y| by a polynomial in |y|^2 - 1.
struct part_to_orbit {
  static constexpr int degree = 10;
  static constexpr double reach = 0.2;
  polynomial<degree> scale{};

  /// Of |y|^2 from 1 to 1 + spread.
  part_to_orbit() = default;
  part_to_orbit(double c, double spread)
      : scale(chebyshev_interpolation<degree>([c](long double e) { return c / std::sqrt(1 + e); },
                                              std::max(spread, 1e-300))) {}
  template <class S>
  vec<S, 3> operator()(const vec<S, 3>& y) const {
    const S excess = y[2] * y[2] + (y[1] * y[1] + (y[0] * y[0] - S(1.0)));
    return evaluate(scale, excess) * y;
  }
};

/// Half of the coupling's dissipation, that of each body, half of the coupling's, each with its normalisation.
struct so4_dissipation {
  /// y_i = own_i a_i + other_i b_i of both parts, then to the orbit.
  struct stage {
    std::array<vec<double, 3>, 2> own, other;
    std::array<part_to_orbit, 2> back;
    double spread = 0;

    /// factors: of each part's components; E: exp(2 theta coupling |a| |b| t), t the time of the coupling.
    stage(const std::array<double, 2>& c, const std::array<vec<double, 3>, 2>& factors, double grown) {
      for (std::size_t i = 0; i < 2; ++i) {
        const auto [least, most] = std::ranges::minmax(factors[i].c);
        const double low = std::min(1.0, grown) * least, high = std::max(1.0, grown) * most;
        for (int k = 0; k < 3; ++k) {
          own[i][k] = factors[i][k] * (1 + grown) / (2 * low * c[i]);
          other[i][k] = factors[i][k] * (1 - grown) / (2 * low * c[1 - i]);
        }
        back[i] = {c[i], high * high / (low * low) - 1};
        spread = std::max(spread, high * high / (low * low) - 1);
      }
    }
    template <class S>
    vec<S, 6> operator()(const vec<S, 6>& mu) const {
      std::array<vec<S, 3>, 2> y;
      for (int i = 0; i < 2; ++i) {
        const auto a = so4::part(mu, i), b = so4::part(mu, 1 - i);
        const auto at = static_cast<std::size_t>(i);
        for (int k = 0; k < 3; ++k) y[at][k] = S(own[at][k]) * a[k] + S(other[at][k]) * b[k];
      }
      return so4::joined(back[0](y[0]), back[1](y[1]));
    }
  };

  so4_dissipation(const so4_body& body, const std::array<double, 2>& c, double t)
      : with_bodies(c, damping(body, c, t), grown(body, c, t)), alone(c, {ones, ones}, grown(body, c, t)) {}

  bool fits() const { return with_bodies.spread <= part_to_orbit::reach && alone.spread <= part_to_orbit::reach; }
  template <class S>
  vec<S, 6> operator()(const vec<S, 6>& mu) const {
    return alone(with_bodies(mu));
  }

  static constexpr vec<double, 3> ones{{1, 1, 1}};
  static double grown(const so4_body& body, const std::array<double, 2>& c, double t) {
    return std::exp(body.theta * body.coupling * c[0] * c[1] * t);
  }
  static std::array<vec<double, 3>, 2> damping(const so4_body& body, const std::array<double, 2>& c, double t) {
    std::array<vec<double, 3>, 2> out;
    for (int k = 0; k < 6; ++k) {
      const auto i = static_cast<std::size_t>(k / 3);
      const auto* lambda = &body.inverse_inertia.c[3 * i];
      const double least = std::min({lambda[0], lambda[1], lambda[2]});
      out[i][k % 3] = std::exp(-body.theta * c[i] * c[i] * (lambda[k % 3] - least) * t);
    }
    return out;
  }

  stage with_bodies, alone;
};

/// For states on the orbit of the momentum.
struct so4_body_at : so4_body {
  so4_body_at(so4_body body, const std::vector<double>& momentum, double dt)
      : so4_body(std::move(body)), dt_(dt), c_(lengths(momentum)), whole_(*this, c_, dt), half_(*this, c_, dt / 2) {
    for (int k = 0; k < 6; ++k) shifted_[k] = inverse_inertia[k] - inverse_inertia[3 * (k / 3) + 1];
  }

  /// Whether a step is small enough for the polynomials, and the turns are those of the general case.
  bool fits() const {
    double angle = 0;
    for (int k = 0; k < 6; ++k) angle = std::max(angle, std::fabs(shifted_[k]) * c_[static_cast<std::size_t>(k / 3)]);
    const bool general = shifted_[0] != shifted_[2] && shifted_[3] != shifted_[5];
    return general && theta > 0 && whole_.fits() && dt_ * angle <= turn_reach;
  }

  template <class S, int n>
  vec<S, 6> dissipation_flow(const vec<S, 6>& mu, part_of_step<n>) const {
    if constexpr (n == 1) return whole_(mu);
    return half_(mu);
  }
  template <class S, int n>
  vec<S, 6> free_flow(const vec<S, 6>& mu, part_of_step<n>) const {
    const part_of_step<2 * n> half;
    return first_turn(last_turn(first_turn(mu, half), part_of_step<n>{}), half);
  }
  template <class S, int n>
  vec<S, 6> first_turn(const vec<S, 6>& mu, part_of_step<n>) const {
    return about_the_sum(mu, dt_ * coupling / n);
  }
  template <class S, int n>
  vec<S, 6> last_turn(vec<S, 6> mu, part_of_step<n>) const {
    turns<0>(mu, dt_ / (2 * n));
    turns<2>(mu, dt_ / n);
    turns<0>(mu, dt_ / (2 * n));
    return mu;
  }

 private:
  static constexpr double turn_reach = 0.3;

  static std::array<double, 2> lengths(const std::vector<double>& m) {
    return {std::hypot(m[0], m[1], m[2]), std::hypot(m[3], m[4], m[5])};
  }
  /// Each body about its own axis.
  template <int axis, class S>
  void turns(vec<S, 6>& mu, double t) const {
    constexpr int next = (axis + 1) % 3, last = (axis + 2) % 3;
    static constexpr auto sinc = cosine_polynomial<4>(1, turn_reach * turn_reach);
    static constexpr auto cosc = cosine_polynomial<4>(2, turn_reach * turn_reach);
    for (const int part : {0, 3}) {
      const S angle = S(t * shifted_[part + axis]) * mu[part + axis], q = angle * angle;
      const S sin = angle * evaluate(sinc, q), cos = S(1.0) - q * evaluate(cosc, q);
      const S a = mu[part + next], b = mu[part + last];
      mu[part + next] = a * cos + b * sin;
      mu[part + last] = b * cos - a * sin;
    }
  }

  double dt_;
  std::array<double, 2> c_;
  vec<double, 6> shifted_{};  ///< 1/I_k - 1/I_2 of each body
  so4_dissipation whole_, half_;
};

}  // namespace polhode
