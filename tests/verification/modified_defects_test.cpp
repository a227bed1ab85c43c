// SPDX-License-Identifier: Apache-2.0
// Which equation a scheme solves: defects and over-claims that have to be refuted.
#include <gtest/gtest.h>

#include <memory>
#include <ostream>
#include <span>

#include "experiments/modified/modified_steps.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "support/kernel_decorator.hpp"
#include "support/verdicts.hpp"

namespace polhode {
namespace {

using test::quick_results, test::scheme_of, test::verdict_of;

constexpr std::string_view parameters = "parameters converge to the scene's",
                           residual = "residual falls at the weak order";

using scene_change = void (*)(report::scene&);

/// The scheme as it is on one scene, held to another: what a wrong number in its code would be.
subject with_scheme_changed(const report::scene& scene, std::string_view scheme, scene_change wrong) {
  auto changed = scene;
  wrong(changed);
  auto s = bind_scene(scene);
  s.schemes = {scheme_of(bind_scene(changed), scheme)};
  s.with = [s](const report::scene&) { return s; };
  return s;
}

template <int Percent>
void stronger_noise(report::scene& s) {
  for (auto& v : s.vectors("sigma"))
    for (auto& x : v) x *= 1 + Percent / 1000.0;
}

struct scene_defect {
  const char *name, *scheme;
  scene_change wrong;
  friend void PrintTo(const scene_defect& d, std::ostream* out) { *out << d.name << ", " << d.scheme; }
};

struct ModifiedDefects : testing::TestWithParam<scene_defect> {};

TEST_P(ModifiedDefects, AreRefuted) {
  const auto r =
      quick_results(with_scheme_changed(load_scene("paper"), GetParam().scheme, GetParam().wrong), {"modified"});
  EXPECT_EQ(verdict_of(r, parameters).kind, report::verdict_kind::refuted) << verdict_of(r, parameters).reason;
}

constexpr scene_change noise_strong = stronger_noise<1>, noise_weak = stronger_noise<-1>,
                       theta_large = [](report::scene&s) { s.number("theta") *= 1.001; },
                       inertia_one = [](report::scene&s) { s.vector("inertia")[0] *= 1.01; },
                       inertia_two = [](report::scene&s) { s.vector("inertia")[1] *= 0.999; },
                       inertia_three = [](report::scene&s) { s.vector("inertia")[2] *= 1.001; },
                       turned_noise = [](report::scene&s) {
                         s.vectors("sigma")[0] = {0.5, 0.0005, 0};
                       };

INSTANTIATE_TEST_SUITE_P(Planted, ModifiedDefects,
                         testing::Values(scene_defect{"noise 0.1 % strong", "lie_euler", noise_strong},
                                         scene_defect{"noise 0.1 % strong", "strang_weak2", noise_strong},
                                         scene_defect{"noise 0.1 % weak", "lie_euler", noise_weak},
                                         scene_defect{"noise 0.1 % weak", "strang_weak2", noise_weak},
                                         scene_defect{"theta 0.1 % large", "lie_euler", theta_large},
                                         scene_defect{"theta 0.1 % large", "strang_weak2", theta_large},
                                         scene_defect{"I_1 1 % large", "lie_euler", inertia_one},
                                         scene_defect{"I_1 1 % large", "strang_weak2", inertia_one},
                                         scene_defect{"I_2 0.1 % small", "lie_euler", inertia_two},
                                         scene_defect{"I_2 0.1 % small", "strang_weak2", inertia_two},
                                         scene_defect{"I_3 0.1 % large", "lie_euler", inertia_three},
                                         scene_defect{"I_3 0.1 % large", "strang_weak2", inertia_three},
                                         scene_defect{"channels correlated by 0.001", "lie_heun", turned_noise},
                                         scene_defect{"channels correlated by 0.001", "implicit_midpoint",
                                                      turned_noise}));

// Weak noise hides dt behind dt^2 in every slope; the coefficient of dt is seen all the same.
TEST(Modified, WeakOrderTwoOverclaimedIsRefutedUnderWeakNoise) {
  for (const double sigma : {0.1, 0.05}) {
    auto scene = load_scene("paper");
    scene.vectors("sigma") = {{sigma, 0, 0}, {0, sigma, 0}, {0, 0, sigma}};
    auto s = bind_scene(scene);
    const auto healthy = scheme_of(s, "strang_weak2");
    auto poser = scheme_of(s, "strang");
    poser.info = healthy.info;
    s.schemes = {poser};
    const auto r = quick_results(s, {"modified"});
    EXPECT_EQ(verdict_of(r, parameters).kind, report::verdict_kind::refuted)
        << sigma << ": " << verdict_of(r, parameters).reason;
    s.schemes = {healthy};
    const auto of_healthy = quick_results(s, {"modified"});
    for (const auto claim : {parameters, residual})
      EXPECT_EQ(verdict_of(of_healthy, claim).kind, report::verdict_kind::holds) << sigma << ": " << claim;
  }
}

/// Leaves out the last step of every run of more than one.
class forgetful final : public test::kernel_decorator {
 public:
  using kernel_decorator::advance, kernel_decorator::kernel_decorator;
  void advance(std::span<double> states, const increment_view& v, piece p) const override {
    auto fewer = v;
    if (v.steps > 1) --fewer.steps;
    kernel_decorator::advance(states, fewer, p);
  }
};

TEST(Modified, ALoopThatLeavesOutItsLastStepIsRefuted) {
  const auto s = bind_scene(load_scene("paper"));
  ASSERT_FALSE(s.schemes.empty());
  for (auto scheme : s.schemes) {
    EXPECT_EQ(judge_steps({s}, scheme).kind, report::verdict_kind::holds) << judge_steps({s}, scheme).reason;
    scheme.make = [inner = scheme.make](double dt) { return std::make_unique<forgetful>(inner(dt)); };
    EXPECT_EQ(judge_steps({s}, scheme).kind, report::verdict_kind::refuted) << scheme.info.name;
  }
}

}  // namespace
}  // namespace polhode
