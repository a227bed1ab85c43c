// Experiment attractor: noise that is shared wrongly, and bodies that do not meet, are refuted.
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
#include "systems/bind.hpp"

namespace polhode {
namespace {

using change = std::function<void(std::span<double> dw)>;

/// A kernel that goes wrong over many steps under one noise. Single ones, as in the transfer operator, are right.
class wrong_sharing final : public test::kernel_decorator {
 public:
  using kernel_decorator::advance;
  wrong_sharing(std::unique_ptr<kernel> inner, change how, bool from_the_start)
      : kernel_decorator(std::move(inner)), how_(std::move(how)), from_the_start_(from_the_start) {}

  /// The right noise and, behind it, the wrong one.
  shared_steps share(const increment_view& path) const override {
    std::vector<double> dw(path.dw.begin(), path.dw.end());
    dw.insert(dw.end(), path.dw.begin(), path.dw.end());
    how_(std::span(dw).subspan(path.dw.size()));
    auto twice = path;
    twice.dw = dw;
    twice.steps = 2 * path.steps;
    return kernel_decorator::share(twice);
  }
  void advance(std::span<double> states, const shared_steps& noise, std::int64_t first, std::int64_t steps,
               piece p) const override {
    const auto wrong = static_cast<std::int64_t>(noise.table.size() / noise.words / 2);
    kernel_decorator::advance(states, noise, steps == 1 ? first : wrong + (from_the_start_ ? 0 : first), steps, p);
  }

 private:
  change how_;
  bool from_the_start_;
};

std::optional<report::verdict_kind> verdict_with(const change& how, bool from_the_start, const std::string& claim) {
  auto s = restricted(bind_scene(load_scene("paper")), {"lie_heun"});
  s.schemes[0].make = [=, make = s.schemes[0].make](double dt) -> std::unique_ptr<kernel> {
    return std::make_unique<wrong_sharing>(make(dt), how, from_the_start);
  };
  report::results out;
  attractor_experiment().run({s, effort::quick, 2}, out);
  for (const auto& v : out.verdicts)
    if (v.claim == claim) return v.kind;
  return std::nullopt;
}

TEST(Attractor, StrongerCommonNoiseIsNotTheSchemesOwnLaw) {
  const auto stronger = [](std::span<double> dw) {
    for (double& x : dw) x *= 1.5;
  };
  EXPECT_EQ(verdict_with(stronger, false, "mean over noise paths"), report::verdict_kind::refuted);
}

TEST(Attractor, OneNoiseForAllPathsDoesNotAverageOut) {
  const auto the_same = [](std::span<double> dw) {
    for (std::size_t i = 0; i < dw.size(); ++i) dw[i] = 0.2 * std::sin(static_cast<double>(i * i));
  };
  EXPECT_EQ(verdict_with(the_same, false, "slope over noise paths"), report::verdict_kind::refuted);
}

TEST(Attractor, NoiseCountedFromTheStartDoesNotConverge) {
  const auto as_it_is = [](std::span<double>) {};
  EXPECT_EQ(verdict_with(as_it_is, true, "pullback converges"), report::verdict_kind::refuted);
}

// Half the dissipation: then bodies spread.
TEST(Attractor, BodiesThatDoNotMeetDoNotCollapse) {
  auto damped = load_scene("paper");
  damped.number("theta") = 1;
  auto s = restricted(bind_scene(damped), {"lie_heun"});
  s.schemes[0].make = restricted(bind_scene(load_scene("paper")), {"lie_heun"}).schemes[0].make;
  report::results out;
  attractor_experiment().run({s, effort::quick, 2}, out);
  const auto found = std::ranges::find(out.verdicts, "collapse at the rate lambda_1", &report::verdict::claim);
  ASSERT_NE(found, out.verdicts.end());
  EXPECT_EQ(found->kind, report::verdict_kind::refuted) << found->reason;
}

}  // namespace
}  // namespace polhode
