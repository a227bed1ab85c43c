// SPDX-License-Identifier: Apache-2.0
// Experiment attractor: its claims hold where bodies spread and where they collect, and threads change nothing.
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <string_view>

#include "reports/writers/json.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "support/verdicts.hpp"

namespace polhode {
namespace {

report::results attractor_of(const scene& s, std::vector<std::string> schemes, int threads = 2) {
  return test::quick_results(s, {"attractor"}, std::move(schemes), threads);
}

const report::results& on_paper() {
  static const auto r = attractor_of(load_scene("paper"), {"lie_euler", "strang_weak2"});
  return r;
}

scene damped() {
  auto s = load_scene("paper");
  s.number("theta") = 1;
  return s;
}

void expect_to_hold(const report::results& r, const std::string& claim, std::size_t count) {
  std::size_t found = 0;
  for (const auto& v : r.verdicts) {
    if (v.claim != claim || v.kind == report::verdict_kind::not_tried) continue;
    ++found;
    EXPECT_EQ(v.kind, report::verdict_kind::holds) << v.scheme << ": " << v.reason;
  }
  EXPECT_EQ(found, count) << claim;
}

std::optional<report::measurement> sampled_row(const report::results& r, std::string_view scheme,
                                               std::string_view quantity, std::string_view method = "sampled") {
  for (const auto& m : r.measurements)
    if (m.scheme == scheme && m.quantity == quantity && m.method == method && m.over.empty()) return m;
  return std::nullopt;
}

void expect_dimensions_in_their_order() {
  const auto pairs = sampled_row(on_paper(), "", "correlation dimension"),
             information = sampled_row(on_paper(), "", "information dimension"),
             boxes = sampled_row(on_paper(), "", "box-counting dimension");
  ASSERT_TRUE(pairs && information && boxes);
  EXPECT_LT(*pairs->value, *information->value);
  EXPECT_LT(*information->value, *boxes->value);
}

// The distance that averages are to keep in the end: seen for a scheme of order one, hardly for one of order two.
void expect_the_exact_bias_to_tell_the_orders_apart() {
  const auto first = sampled_row(on_paper(), "lie_euler", "distance to the true law", "transfer"),
             second = sampled_row(on_paper(), "strang_weak2", "distance to the true law", "transfer");
  ASSERT_TRUE(first && second);
  EXPECT_GT(*first->value, 0.025);
  EXPECT_LT(*second->value, 0.001);
}

void expect_densities_relative_to_the_uniform_one() {
  const auto& all = on_paper().densities;
  ASSERT_EQ(all.size(), 5u);
  for (const auto& d : all) {
    ASSERT_EQ(d.values.size(), 128u * 64u);
    double sum = 0, height2 = 0;
    for (std::size_t i = 0; i < d.values.size(); ++i) {
      EXPECT_GE(d.values[i], 0);
      const auto height = i / 128;
      const double z = 2 * (static_cast<double>(height) + 0.5) / 64 - 1;
      sum += d.values[i] / 8192;
      height2 += d.values[i] / 8192 * z * z;
    }
    EXPECT_NEAR(sum, 1, 2e-3) << d.name;
    if (d.time) continue;
    EXPECT_EQ(d.name, "stationary law");
    EXPECT_NEAR(height2, 0.40576662289, 1e-3);  // docs/model.md, section 3: E[Pi_3^2]
  }
}

TEST(Attractor, ClaimsHoldWhereBodiesSpread) {
  for (const char* claim : {"slope over noise paths", "mean over noise paths", "pullback converges",
                            "neighbours part at the rate lambda_1"})
    expect_to_hold(on_paper(), claim, 2);
  expect_dimensions_in_their_order();
  expect_the_exact_bias_to_tell_the_orders_apart();
  expect_densities_relative_to_the_uniform_one();
  test::expect_noise_of(on_paper(), {"averages", "pullback", "neighbours", "dimensions", "densities"});
}

TEST(Attractor, ClaimsHoldWhereBodiesCollect) {
  const auto r = attractor_of(damped(), {"strang", "lie_heun"});
  for (const char* claim :
       {"slope over noise paths", "mean over noise paths", "pullback converges", "collapse at the rate lambda_1"})
    expect_to_hold(r, claim, 2);
  EXPECT_NEAR(*sampled_row(r, "strang", "collapse rate")->value, -0.04358, 0.1 * 0.04358);  // docs/model.md, section 5
  test::expect_noise_of(r, {"averages", "pullback", "collapse", "densities"});
}

TEST(Attractor, ThreadsChangeNothing) {
  const auto text = [](int threads) {
    auto r = attractor_of(load_scene("paper"), {"lie_heun"}, threads);
    r.provenance = {};
    return report::to_json(r);
  };
  EXPECT_EQ(text(1), text(3));
}

TEST(Attractor, IsSkippedWithAReasonWhereItSaysNothing) {
  auto ball = load_scene("paper"), undamped = ball, silent = ball;
  ball.vector("inertia") = {2, 2, 2};
  undamped.number("theta") = 0;
  silent.vectors("sigma").clear();
  for (const auto& s : {ball, undamped, silent}) {
    const auto r = attractor_of(s, {"strang"});
    ASSERT_FALSE(r.skipped.empty());
    EXPECT_TRUE(r.measurements.empty());
    ASSERT_FALSE(r.verdicts.empty());
    for (const auto& v : r.verdicts) EXPECT_EQ(v.kind, report::verdict_kind::skipped);
  }
}

}  // namespace
}  // namespace polhode
