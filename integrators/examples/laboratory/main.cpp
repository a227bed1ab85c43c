// SPDX-License-Identifier: Apache-2.0
// A scheme of one's own against the laboratory's claims, beside two of the laboratory's.
#include <polhode/schemes/heun.hpp>
#include <polhode/schemes/lie_heun.hpp>

#include "reports/writers/folder.hpp"
#include "run/verify.hpp"
#include "systems/bind.hpp"
#include "systems/rigid_body/rigid_body.hpp"

/// mu* = Ad*_exp(xi(mu)/2) mu,   mu_{n+1} = Ad*_exp(xi(mu*)) mu_n
struct my_scheme {
  static constexpr polhode::scheme_info info{.name = "my_scheme",
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
  const auto subject = bind(load_scene("paper"), make_rigid_body, scheme_list<heun, lie_heun, my_scheme>{});
  const auto results = verify_subject(subject, {.effort = effort::quick, .threads = 2});
  report::write_report("report", {&results, 1});
}
