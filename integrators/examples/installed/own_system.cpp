// SPDX-License-Identifier: Apache-2.0
// A system of your own: its energy and the gradient of it. A rotor inside the body, h = Pi.Pi/(2 I) + rotor.Pi; without
// noise dh/dt = -theta |Pi x Omega|^2, so the energy never rises.
#include <cmath>
#include <cstdio>
#include <polhode/integrate.hpp>
#include <polhode/lie/so3.hpp>
#include <polhode/schemes/lie_heun.hpp>
#include <polhode/systems/double_bracket.hpp>

struct gyrostat : polhode::double_bracket<gyrostat, polhode::so3> {
  explicit gyrostat(double dissipation)
      : double_bracket(dissipation, polhode::constant_noise<polhode::so3>::isotropic(0)) {}

  template <class S>
  polhode::vec<S, 3> omega(const polhode::vec<S, 3>& pi) const {
    return {{pi[0], S(0.5) * pi[1], S(1.0 / 3) * pi[2] + S(rotor)}};
  }
  template <class S>
  S energy(const polhode::vec<S, 3>& pi) const {
    return S(0.5) * (pi[0] * pi[0] + S(0.5) * pi[1] * pi[1] + S(1.0 / 3) * pi[2] * pi[2]) + S(rotor) * pi[2];
  }
  double rotor = 0.2;
};

int main() {
  using namespace polhode;
  const gyrostat body(0.5);
  vec<double, 3> pi{{0.6, 0.48, 0.64}};
  double energy = body.energy(pi);
  bool falls = true;
  for (int i = 0; i < 100; ++i) {
    pi = integrate<lie_heun>(body, pi, 0.01, 50);
    falls = falls && body.energy(pi) <= energy;
    energy = body.energy(pi);
  }
  std::printf("h = %.6f, |Pi|^2 - 1 = %.0e, %s\n", energy, dot(pi, pi) - 1, falls ? "never rose" : "rose");
  return falls && std::fabs(dot(pi, pi) - 1) < 1e-12 ? 0 : 1;
}
