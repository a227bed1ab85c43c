// SPDX-License-Identifier: Apache-2.0
// Noise that depends on the state goes through the same steps, kernels and operators. A spin whose noise is inside the
// damping too,
//
//   sigma_i(S) = s (e_i + alpha S x e_i):  sum V_i^2 = (1 + alpha^2 |S|^2) s^2 Laplacian,
//
// is in law one with constant noise of strength s sqrt(1 + alpha^2 |S|^2), which is exactly known. Of
// sigma_1(Pi) = s (1 + slope Pi_2) e_1 beside s e_2 and s e_3 Kolmogorov's operator is known, and here it matters that
// sigma changes within a step.
#include <gtest/gtest.h>

#include <algorithm>

#include <polhode/systems/rigid_body.hpp>

#include "problem/vectors.hpp"
#include "run/reference.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "support/verdicts.hpp"
#include "systems/bind.hpp"
#include "systems/rigid_body/rigid_body.hpp"

namespace polhode::test {
namespace {

using report::verdict_kind;
using test::quick_results;

constexpr double alpha = 0.8;

class damped_noise_body {
 public:
  using algebra = so3;
  static constexpr int dimension = 3, channels = 3;

  damped_noise_body(rigid_body body, double strength, double radius)
      : body_(std::move(body)), strength_(strength), alpha_(alpha / radius) {}

  template <class S>
  vec<S, 3> generator(const vec<S, 3>& pi) const {
    return body_.generator(pi);
  }
  template <class S>
  S energy(const vec<S, 3>& pi) const {
    return body_.energy(pi);
  }
  template <class S>
  S dissipation_rate(const vec<S, 3>& pi) const {
    return body_.dissipation_rate(pi);
  }
  template <class S>
  vec<S, 3> noise_at(const vec<S, 3>& pi, const wiener<S, 3>& w) const {
    return S(strength_) * (w.dw + S(alpha_) * cross(pi, w.dw));
  }
  template <class S>
  vec<S, 3> ito_drift(const vec<S, 3>& pi) const {
    const S factor = S(1.0) + S(alpha_ * alpha_) * dot(pi, pi);
    return S(S(-strength_ * strength_) * factor) * pi;
  }
  noise_class classify() const { return noise_class::isotropic; }
  int active_channels() const { return 3; }

  template <class S, class Time>
  vec<S, 3> dissipation_flow(const vec<S, 3>& pi, Time t) const {
    return body_.dissipation_flow(pi, t);
  }
  template <class S, class Time>
  vec<S, 3> free_flow(const vec<S, 3>& pi, Time t) const {
    return body_.free_flow(pi, t);
  }
  template <class S, class Time>
  vec<S, 3> first_turn(const vec<S, 3>& pi, Time t) const {
    return body_.first_turn(pi, t);
  }
  template <class S, class Time>
  vec<S, 3> last_turn(const vec<S, 3>& pi, Time t) const {
    return body_.last_turn(pi, t);
  }

 private:
  rigid_body body_;
  double strength_, alpha_;
};

/// The scene's sigma is the constant noise of the same law.
damped_noise_body make(const report::scene& s) {
  return {make_rigid_body(s), s.vectors("sigma").at(0).at(0) / std::sqrt(1 + alpha * alpha), length(s.momentum)};
}

constexpr double strength = 0.5, slope = 0.8;

class tilting_noise_body : public damped_noise_body {
 public:
  explicit tilting_noise_body(const report::scene& s) : damped_noise_body(make_rigid_body(s), 0, 1) {}

  template <class S>
  vec<S, 3> noise_at(const vec<S, 3>& pi, const wiener<S, 3>& w) const {
    return {
        {S((S(strength) + S(strength * slope) * pi[1]) * w.dw[0]), S(S(strength) * w.dw[1]), S(S(strength) * w.dw[2])}};
  }
  /// Half the derivative of V = Pi x sigma along V, of every sigma.
  template <class S>
  vec<S, 3> ito_drift(const vec<S, 3>& pi) const {
    const vec<S, 3> sigma{{S(S(strength) + S(strength * slope) * pi[1]), S(0.0), S(0.0)}};
    const auto v = cross(pi, sigma);
    const vec<S, 3> change{{S(S(strength * slope) * v[1]), S(0.0), S(0.0)}};
    const S square(strength * strength);
    const vec<S, 3> constant{{S(S(2.0) * square * pi[0]), S(square * pi[1]), S(square * pi[2])}};
    return S(0.5) * (cross(pi, change) + cross(v, sigma) - constant);
  }
  noise_class classify() const { return noise_class::general; }
  int active_channels() const { return 3; }
};

template <class... Schemes>
subject tilting(scheme_list<Schemes...> schemes) {
  auto s = bind(
      load_scene("paper"), [](const report::scene& x) { return tilting_noise_body(x); }, schemes);
  auto known = *s.offers;
  known.sphere->covariance = strength * strength * Eigen::Vector3d(0, 1, 1).asDiagonal();
  const Eigen::Vector3d e1 = Eigen::Vector3d::UnitX(), e2 = Eigen::Vector3d::UnitY();
  known.sphere->varying = {{strength * e1, strength * slope * e1 * e2.transpose()}};
  s.offers = std::make_shared<const capabilities>(known);
  return s;
}

/// Taken at the start of the step alone: that is Ito's calculus, and another equation.
struct frozen : lie_heun {
  template <lie_poisson_system System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    return System::algebra::exp_action(generator(system, mu, w), mu);
  }
};

TEST(StateNoise, SchemesThatRestOnConstantVectorsAreLeftOut) {
  const auto s = bind(load_scene("paper"), make, all_schemes{});
  std::vector<std::string> out;
  for (const auto& one : s.inapplicable) {
    out.push_back(one.scheme);
    EXPECT_NE(one.reason.find("depend on the state"), std::string::npos) << one.reason;
  }
  EXPECT_EQ(out, (std::vector<std::string>{"milstein", "milstein_no_area", "lie_euler", "lie_milstein", "magnus",
                                           "strang_two_turns", "strang_weak2"}));
}

void expect_none_refuted(const char* scene, const char* experiment, std::vector<std::string> schemes) {
  const auto r = quick_results(load_scene(scene), {experiment}, std::move(schemes));
  EXPECT_FALSE(r.verdicts.empty()) << scene << ' ' << experiment;
  for (const auto& v : r.verdicts)
    EXPECT_NE(v.kind, verdict_kind::refuted) << scene << ' ' << v.scheme << ' ' << v.claim << ": " << v.reason;
}

TEST(StateNoise, OfTheScenesMeetsTheClaims) {
  for (const char* scene : {"random_inertia", "thermal_spin"})
    expect_none_refuted(scene, "strong", {"milstein", "magnus", "lie_milstein", "srkmk3", "strang"});
  for (const char* experiment : {"weak", "gibbs"})
    expect_none_refuted("thermal_spin", experiment, {"isospectral_midpoint", "strang"});
}

/// sum V_i^2 = (1 + theta^2) s^2 Laplacian on the unit sphere.
TEST(StateNoise, InsideTheDampingHasTheMeansOfStrongerConstantNoise) {
  auto inside = load_scene("thermal_spin"), constant = inside;
  std::erase_if(constant.parameters, [](const auto& p) { return p.name == "noise"; });
  constant = with_noise_times(constant, std::sqrt(1 + 0.4 * 0.4));
  for (const char* quantity : {"expectation", "gibbs"})
    for (const char* observable : {"energy", "pi1", "pi3^2"}) {
      const auto a = reference(inside, {quantity, observable, {}, 0}),
                 b = reference(constant, {quantity, observable, {}, 0});
      EXPECT_NEAR(a.value, b.value, 1e-11) << quantity << ' ' << observable;
    }
}

using stratonovich_schemes =
    scheme_list<euler_maruyama, heun, heun_projected, implicit_midpoint, lie_heun, cayley_heun, lie_trotter, strang>;

void expect_all_hold(const report::results& r) {
  ASSERT_FALSE(r.verdicts.empty());
  for (const auto& v : r.verdicts)
    EXPECT_EQ(v.kind, verdict_kind::holds) << v.scheme << ' ' << v.claim << ": " << v.reason;
}

TEST(StateNoise, InsideTheDampingHasTheLawOfConstantNoiseAtTheClaimedOrder) {
  expect_all_hold(quick_results(bind(load_scene("paper"), make, stratonovich_schemes{}), {"weak"}));
}

TEST(StateNoise, OfKolmogorovsOperatorIsMetAtTheClaimedOrder) {
  expect_all_hold(
      quick_results(tilting(scheme_list<heun, implicit_midpoint, lie_heun, lie_trotter, strang>{}), {"weak"}));
}

TEST(StateNoise, FrozenOverAStepItIsAnotherEquation) {
  const auto r = quick_results(tilting(scheme_list<frozen>{}), {"weak"});
  EXPECT_TRUE(std::ranges::any_of(r.verdicts, [](const auto& v) { return v.kind == verdict_kind::refuted; }));
}

}  // namespace
}  // namespace polhode::test
