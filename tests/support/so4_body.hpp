// A second system, to keep schemes from growing fond of dimension three: so(4) = so(3) + so(3), one cross product in
// each factor, dissipation and noise in both, two Casimirs. Coupled through the energy, so that it is not two bodies
// side by side.
#pragma once

#include <polhode/lie/so3.hpp>
#include <polhode/systems/constant_noise.hpp>
#include <polhode/systems/lie_poisson.hpp>

namespace polhode::test {

/// so(3) + so(3): every operation factor by factor.
struct so4 {
  static constexpr int dimension = 6;

  template <class S>
  static vec<S, 3> part(const vec<S, 6>& v, int which) {
    return {{v[3 * which], v[3 * which + 1], v[3 * which + 2]}};
  }
  template <class S>
  static vec<S, 6> joined(const vec<S, 3>& a, const vec<S, 3>& b) {
    return {{a[0], a[1], a[2], b[0], b[1], b[2]}};
  }
  template <class F, class S>
  static vec<S, 6> both(F f, const vec<S, 6>& a, const vec<S, 6>& b) {
    return joined(f(part(a, 0), part(b, 0)), f(part(a, 1), part(b, 1)));
  }
  template <class S>
  static vec<S, 6> bracket(const vec<S, 6>& a, const vec<S, 6>& b) {
    return both([](auto x, auto y) { return so3::bracket(x, y); }, a, b);
  }
  template <class S>
  static vec<S, 6> coad(const vec<S, 6>& a, const vec<S, 6>& b) {
    return both([](auto x, auto y) { return so3::coad(x, y); }, a, b);
  }
  template <class S>
  static vec<S, 6> exp_action(const vec<S, 6>& a, const vec<S, 6>& b) {
    return both([](auto x, auto y) { return so3::exp_action(x, y); }, a, b);
  }
  template <class S>
  static vec<S, 6> cayley_action(const vec<S, 6>& a, const vec<S, 6>& b) {
    return both([](auto x, auto y) { return so3::cayley_action(x, y); }, a, b);
  }
  template <class S>
  static vec<S, 6> dexp_inv(const vec<S, 6>& a, const vec<S, 6>& b) {
    return both([](auto x, auto y) { return so3::dexp_inv(x, y); }, a, b);
  }
  template <class S>
  static vec<S, 6> orbit_projection(const vec<S, 6>& a, const vec<S, 6>& b) {
    return both([](auto x, auto y) { return so3::orbit_projection(x, y); }, a, b);
  }
  template <class S>
  static vec<S, 2> casimirs(const vec<S, 6>& mu) {
    return {{so3::casimirs(part(mu, 0))[0], so3::casimirs(part(mu, 1))[0]}};
  }
};

/// h = 1/2 sum mu_k^2 / I_k + coupling mu_1 . mu_2 (the two factors' vectors).
struct so4_body : constant_noise<so4> {
  using algebra = so4;
  vec<double, 6> inverse_inertia{{1.0, 0.5, 1.0 / 3, 0.8, 0.4, 0.6}};
  double coupling = 0.3;
  double theta = 0.4;

  so4_body() : constant_noise(matrix(0.3 * matrix::Identity())) {}
  explicit so4_body(const matrix& sigma) : constant_noise(sigma) {}

  so4_body with_noise(const constant_noise<so4>& other) const {
    so4_body copy = *this;
    static_cast<constant_noise<so4>&>(copy) = other;
    return copy;
  }
  template <class S>
  vec<S, 6> omega(const vec<S, 6>& mu) const {
    return scaled(inverse_inertia, mu) + S(coupling) * so4::joined(so4::part(mu, 1), so4::part(mu, 0));
  }
  template <class S>
  S energy(const vec<S, 6>& mu) const {
    return S(0.5) * dot(mu, omega(mu));
  }
  template <class S>
  vec<S, 6> generator(const vec<S, 6>& mu) const {
    const auto w = omega(mu);
    return w + S(theta) * so4::coad(w, mu);
  }
  template <class S>
  S dissipation_rate(const vec<S, 6>& mu) const {
    const auto c = so4::coad(omega(mu), mu);
    return S(theta) * dot(c, c);
  }
  /// The parts' flows, to second order: enough for the splittings to show their own order.
  template <class S>
  vec<S, 6> free_flow(const vec<S, 6>& mu, double t) const {
    return flow([this](const auto& x) { return this->omega(x); }, mu, t);
  }
  /// The coupling alone: mu_1 + mu_2 stays, and both turn about it. Exact.
  template <class S>
  vec<S, 6> first_turn(const vec<S, 6>& mu, double t) const {
    const auto axis = S(t * coupling) * (so4::part(mu, 0) + so4::part(mu, 1));
    return so4::exp_action(so4::joined(axis, axis), mu);
  }
  template <class S>
  vec<S, 6> last_turn(const vec<S, 6>& mu, double t) const {
    return flow([this](const auto& x) { return scaled(inverse_inertia, x); }, mu, t);
  }
  template <class S>
  vec<S, 6> dissipation_flow(const vec<S, 6>& mu, double t) const {
    return flow([this](const auto& x) { return S(theta) * so4::coad(omega(x), x); }, mu, t);
  }

 private:
  template <class F, class S>
  static vec<S, 6> flow(F generator, const vec<S, 6>& mu, double t) {
    const auto first = S(t) * generator(mu);
    const auto second = S(t) * generator(so4::exp_action(first, mu));
    return so4::exp_action(S(0.5) * (first + second), mu);
  }
};

}  // namespace polhode::test
