// SPDX-License-Identifier: Apache-2.0
// What the tests of the exponents of the schemes share: subjects, two defects that only exponents can see, and answers
// held against each other.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "run/run_experiment.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "systems/bind.hpp"
#include "systems/rigid_body/rigid_body.hpp"

namespace polhode::test {

inline subject with_schemes(const report::scene& scene, const std::vector<std::string>& schemes) {
  return restricted(bind_scene(scene), schemes);
}

inline report::verdict_kind verdict_kind_of(const report::results& r, std::string_view scheme, std::string_view claim) {
  for (const auto& v : r.verdicts)
    if (v.scheme == scheme && v.claim == claim) return v.kind;
  return report::verdict_kind::skipped;
}

/// The state of Lie-Euler, but tangents that do not see how the generator depends on it.
struct generator_frozen_in_the_tangent {
  static constexpr auto info = [] {
    auto claims = lie_euler::info;
    claims.name = "generator_frozen_in_the_tangent";
    return claims;
  }();
  template <class S, int N>
  static auto frozen(vec<S, N> mu) {
    if constexpr (requires { mu[0].slope; })
      for (auto& x : mu.c) x.slope = {};
    return mu;
  }
  template <class System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    return System::algebra::exp_action(generator(system, frozen(mu), w), mu);
  }
};

/// The Stratonovich equation given the Ito drift as well; on the sphere by projection.
struct ito_drift_added {
  static constexpr auto info = [] {
    auto claims = heun_projected::info;
    claims.name = "ito_drift_added";
    return claims;
  }();
  template <class System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    return System::algebra::orbit_projection(heun::step(system, mu, w) + S(w.dt) * system.ito_drift(mu), mu);
  }
};

template <class Scheme>
subject with_mutant(const report::scene& scene) {
  return bind(scene, make_rigid_body, scheme_list<Scheme>{});
}

/// With isotropic noise the drift of ito_drift_added is radial, and the projection takes it out.
inline report::scene paper_with_unequal_noise() {
  auto scene = load_scene("paper");
  scene.vectors("sigma") = {{0.3, 0, 0}, {0, 0.5, 0}, {0, 0, 0.7}};
  return scene;
}

/// What is said of a scheme alone is what is said of it beside others.
inline void expect_the_same(const report::results& alone, const report::results& beside, std::string_view scheme) {
  std::size_t same = 0;
  const auto of_scheme = [&](const report::measurement& m) { return m.scheme == scheme; };
  auto expected = alone.measurements;
  std::erase_if(expected, std::not_fn(of_scheme));
  for (const auto& m : beside.measurements) {
    if (!of_scheme(m)) continue;
    ASSERT_LT(same, expected.size());
    const auto& other = expected[same++];
    EXPECT_EQ(m.value, other.value) << m.quantity;
    EXPECT_EQ(m.low, other.low) << m.quantity;
  }
  EXPECT_EQ(same, expected.size());
  EXPECT_GT(same, 0u);
}

}  // namespace polhode::test
