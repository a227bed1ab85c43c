// SPDX-License-Identifier: Apache-2.0
// A scheme of your own on any system that ships: one struct with `info` and a pure `step`.
#include <cmath>
#include <cstdio>
#include <polhode/integrate.hpp>
#include <polhode/schemes/strang.hpp>
#include <polhode/systems/rigid_body.hpp>

/// Explicit midpoint in the Lie algebra: mu* = Ad*_exp(xi(mu)/2) mu, mu_{n+1} = Ad*_exp(xi(mu*)) mu_n.
struct lie_midpoint {
  static constexpr polhode::scheme_info info{.name = "lie_midpoint",
                                             .title = "Explicit midpoint in the Lie algebra",
                                             .source = "this file",
                                             .calculus = polhode::calculus::stratonovich,
                                             .strong_order = {.commuting = 1, .general = 0.5},
                                             .weak_order = {.one_vector = 1, .isotropic = 1, .general = 1},
                                             .deterministic_order = 2,
                                             .casimir = polhode::keeps_casimirs};

  template <polhode::lie_poisson_system System, class S>
  static auto step(const System& system, const polhode::vec<S, System::dimension>& mu,
                   const polhode::wiener<S, System::channels>& w) {
    using g = typename System::algebra;
    const auto half = g::exp_action(S(0.5) * generator(system, mu, w), mu);
    return g::exp_action(generator(system, half, w), mu);
  }
};

int main() {
  using namespace polhode;
  const rigid_body silent({1, 2, 3}, 0.5, rigid_body::isotropic(0));
  const vec<double, 3> start{{0.6, 0.48, 0.64}};
  const auto truth = integrate<strang>(silent, start, 1e-4, 10'000);
  double errors[2];
  for (int i = 0; i < 2; ++i) {
    const auto off = integrate<lie_midpoint>(silent, start, 0.02 / (i + 1), 50 * (i + 1)) - truth;
    errors[i] = std::sqrt(dot(off, off));
  }
  std::printf("error %.2e, at half the step %.2e: order %.2f\n", errors[0], errors[1],
              std::log2(errors[0] / errors[1]));
  return std::fabs(std::log2(errors[0] / errors[1]) - 2) < 0.1 ? 0 : 1;
}
