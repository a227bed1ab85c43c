// SPDX-License-Identifier: Apache-2.0
// Experiment attractor: noise that is not the scheme's, a start that is not where it should be, and bodies that do not
// meet, are refuted.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "experiments/common/experiment.hpp"
#include "run/run_experiment.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "support/kernel_decorator.hpp"
#include "support/verdicts.hpp"
#include "systems/bind.hpp"

namespace polhode {
namespace {

/// What becomes of an increment, [step][channel] its row.
using noise_change = std::function<double(double dw, std::size_t row)>;

/// A kernel that goes wrong over many steps. Single ones, as in the transfer operator, are right.
class wrong_noise final : public test::kernel_decorator {
 public:
  using kernel_decorator::advance;
  wrong_noise(std::unique_ptr<kernel> inner, noise_change how)
      : kernel_decorator(std::move(inner)), how_(std::move(how)) {}

  void advance(std::span<double> states, const increment_view& noise, piece p) const override {
    std::vector<double> dw(noise.dw.begin(), noise.dw.end());
    for (std::size_t i = 0; i < dw.size(); ++i) dw[i] = how_(dw[i], i / block_lanes);
    auto wrong = noise;
    wrong.dw = dw;
    kernel_decorator::advance(states, wrong, p);
  }

 private:
  noise_change how_;
};

/// A kernel whose common noise is counted from the first step of a run, whichever it is.
class restarting final : public test::kernel_decorator {
 public:
  using kernel_decorator::advance;
  using kernel_decorator::kernel_decorator;

  void advance(std::span<double> states, const shared_steps& noise, std::int64_t first, std::int64_t steps,
               piece p) const override {
    kernel_decorator::advance(states, noise, steps == 1 ? first : 0, steps, p);
  }
};

template <class Wrong, class... How>
std::optional<report::verdict_kind> verdict_with(const std::string& claim, const How&... how) {
  auto s = restricted(bind_scene(load_scene("paper")), {"lie_heun"});
  s.schemes[0].make = [=, make = s.schemes[0].make](double dt) -> std::unique_ptr<kernel> {
    return std::make_unique<Wrong>(make(dt), how...);
  };
  const auto out = test::quick_report(s, attractor_experiment().run);
  for (const auto& v : out.verdicts)
    if (v.claim == claim) return v.kind;
  return std::nullopt;
}

TEST(Attractor, StrongerNoiseIsNotTheSchemesOwnLaw) {
  const noise_change stronger = [](double dw, std::size_t) { return 1.5 * dw; };
  EXPECT_EQ(verdict_with<wrong_noise>("mean over noise paths", stronger), report::verdict_kind::refuted);
}

TEST(Attractor, OneNoiseForAllPathsDoesNotAverageOut) {
  const noise_change the_same = [](double, std::size_t row) { return 0.2 * std::sin(static_cast<double>(row * row)); };
  EXPECT_EQ(verdict_with<wrong_noise>("slope over noise paths", the_same), report::verdict_kind::refuted);
}

TEST(Attractor, NoiseCountedFromTheStartDoesNotConverge) {
  EXPECT_EQ(verdict_with<restarting>("pullback converges"), report::verdict_kind::refuted);
}

/// That of lie_heun for a scene with this theta whose steps are those of another.
report::verdict with_steps_of(double theta, double theta_of_steps, const std::string& claim) {
  auto scene = load_scene("paper"), other = scene;
  scene.number("theta") = theta;
  other.number("theta") = theta_of_steps;
  auto s = restricted(bind_scene(scene), {"lie_heun"});
  s.schemes[0].make = restricted(bind_scene(other), {"lie_heun"}).schemes[0].make;
  const auto out = test::quick_report(s, attractor_experiment().run);
  const auto found = std::ranges::find(out.verdicts, claim, &report::verdict::claim);
  return found == out.verdicts.end() ? report::verdict{.reason = "not asked"} : *found;
}

// Half the dissipation: then bodies spread.
TEST(Attractor, BodiesThatDoNotMeetDoNotCollapse) {
  const auto found = with_steps_of(1, 0.5, "collapse at the rate lambda_1");
  EXPECT_EQ(found.kind, report::verdict_kind::refuted) << found.reason;
}

// Twice the dissipation: they meet.
TEST(Attractor, BodiesThatMeetDoNotPart) {
  const auto found = with_steps_of(0.5, 1, "neighbours part at the rate lambda_1");
  EXPECT_EQ(found.kind, report::verdict_kind::refuted) << found.reason;
}

}  // namespace
}  // namespace polhode
