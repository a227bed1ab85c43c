// SPDX-License-Identifier: Apache-2.0
// The long runs of the experiment casimir: their noise, and how far they go.
#include "experiments/casimir/casimir_long_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/levels.hpp"
#include "run/bind_scene.hpp"
#include "scene/scene.hpp"
#include "support/kernel_decorator.hpp"

namespace {

using namespace polhode;
using report::verdict_kind;

/// Stays where it is but for what it grows by, in its first chunk and in each; remembers where each chunk's noise
/// began.
struct growth {
  double at_first = 0, in_each = 0;
  std::vector<float> heard = {};
};
class growing final : public test::kernel_decorator {
 public:
  growing(std::unique_ptr<kernel> inner, growth& of) : kernel_decorator(std::move(inner)), of_(of) {}
  void advance(std::span<double> states, const increment_view& noise, piece) const override {
    const double by = of_.in_each + (of_.heard.empty() ? of_.at_first : 0);
    for (double& x : states) x *= 1 + by;
    of_.heard.push_back(noise.singles.front());
  }

 private:
  growth& of_;
};

subject with_one(growth& of) {
  auto s = bind_scene(load_scene("so4"));
  std::erase_if(s.schemes, [](const scheme_entry& e) { return e.info.name != "strang"; });
  auto& make = s.schemes.front().make;
  make = [inner = make, &of](double dt) { return std::make_unique<growing>(inner(dt), of); };
  return s;
}

/// Its one verdict, and after how many steps it was given.
std::pair<report::verdict, double> run(growth& of, int threads) {
  const auto s = with_one(of);
  report::results out;
  noise_log log(*s.model, 1);
  report_long_runs({s, effort::quick, threads}, false, log, out);
  const auto* last = &out.measurements.front();
  for (const auto& m : out.measurements)
    if (m.quantity == "drift_over_steps") last = &m;
  const auto steps = std::ranges::find(last->at, std::string(report::step_count), &report::coordinate::name);
  return {out.verdicts.front(), steps->value};
}

TEST(CasimirLongRun, GoesOnUntilAGuessIsDecided) {
  growth once{4e-13, 0};  // 100 chunks: 1.26e-12 if it grew like a random walk; 200: 0.89e-12
  const auto [verdict, steps] = run(once, 2);
  EXPECT_EQ(verdict.kind, verdict_kind::holds) << verdict.reason;
  EXPECT_EQ(steps, 2e5);
}

TEST(CasimirLongRun, RefutesADriftOnlyWhereItIsMeasured) {
  growth ever{0, 2e-15};
  const auto [verdict, steps] = run(ever, 2);
  EXPECT_EQ(verdict.kind, verdict_kind::refuted) << verdict.reason;
  EXPECT_EQ(steps, 1e6);
}

TEST(CasimirLongRun, EndsWhereItIsDecidedAtOnce) {
  for (const double drift : {0.0, 1e-12}) {
    growth ever{0, drift};
    const auto [verdict, steps] = run(ever, 1);
    EXPECT_EQ(verdict.kind, drift == 0 ? verdict_kind::holds : verdict_kind::refuted) << verdict.reason;
    EXPECT_EQ(steps, 1e5);
  }
}

TEST(CasimirLongRun, HearsEveryChunkOfTheNoiseOnceInItsOrder) {
  for (const int threads : {1, 3}) {
    growth none;
    run(none, threads);
    ASSERT_EQ(none.heard.size(), 100U);
    const auto s = with_one(none);
    increment_buffer noise(*s.model, 1, false, {noise_generator::philox, noise_quality::fast});
    for (std::size_t chunk = 0; chunk < none.heard.size(); ++chunk)
      ASSERT_EQ(none.heard[chunk], noise.fill(1, 0, 1000 * chunk, 1, finest_step(s)).singles.front()) << chunk;
  }
}

}  // namespace
