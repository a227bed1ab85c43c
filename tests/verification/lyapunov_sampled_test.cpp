// SPDX-License-Identifier: Apache-2.0
// The exponents of the schemes by sampled paths: known answers, defects that only they can see, and bits that do not
// depend on threads or on the batch.
#include <gtest/gtest.h>

#include "experiments/common/levels.hpp"
#include "experiments/lyapunov/discretisation_exponents.hpp"
#include "experiments/lyapunov/lyapunov_sampled.hpp"
#include "run/run_experiment.hpp"
#include "transfer/frame_transfer.hpp"
#include "verification/lyapunov_schemes.hpp"

namespace polhode {
namespace {

using namespace test;
using report::verdict_kind;

report::results sampled(const subject& s, int threads = 2) {
  const context c{s, effort::quick, threads};
  report::results out;
  report_sampled_exponents(c, s.schemes, lyapunov(*s.sphere(), 1e-5), out);
  return out;
}

report::scene paper_with(double theta) {
  auto scene = load_scene("paper");
  scene.number("theta") = theta;
  return scene;
}

const report::measurement* row_of(const report::results& r, std::string_view quantity) {
  for (const auto& m : r.measurements)
    if (m.quantity == quantity) return &m;
  return nullptr;
}

void expect_row(const report::results& r, std::string_view quantity, double exact) {
  const auto* m = row_of(r, quantity);
  ASSERT_TRUE(m && m->value && m->dt()) << quantity;
  EXPECT_NEAR(*m->value, exact, 1e-3) << quantity;
  EXPECT_LT(*m->high - *m->low, 2e-3) << quantity;
}

// docs/model.md, section 5: the sign of lambda_1 changes between theta = 1/2 and 1.
TEST(SampledExponents, AreTheKnownOnesWhereTheyArePositive) {
  const auto r = sampled(with_schemes(paper_with(0.5), {"strang_weak2"}));
  expect_row(r, "lambda_1", 0.020196);
  expect_row(r, "lambda_1 + lambda_2", -0.0867830798);
}
TEST(SampledExponents, AreTheKnownOnesWhereTheyAreNegative) {
  const auto r = sampled(with_schemes(paper_with(1), {"strang_weak2"}));
  expect_row(r, "lambda_1", -0.04358);
  expect_row(r, "lambda_1 + lambda_2", -0.3056934656);
}

TEST(SampledExponents, AWrongTangentIsRefuted) {
  const auto r = sampled(with_mutant<generator_frozen_in_the_tangent>(load_scene("paper")));
  EXPECT_EQ(verdict_kind_of(r, "generator_frozen_in_the_tangent", "finds lambda_1"), verdict_kind::refuted);
  EXPECT_EQ(verdict_kind_of(r, "generator_frozen_in_the_tangent", "finds lambda_1 + lambda_2"), verdict_kind::refuted);
}

TEST(SampledExponents, TheWrongEquationIsRefuted) {
  const auto r = sampled(with_mutant<ito_drift_added>(paper_with_unequal_noise()));
  EXPECT_EQ(verdict_kind_of(r, "ito_drift_added", "finds lambda_1 + lambda_2"), verdict_kind::refuted);
}

TEST(SampledExponents, ThreadsAndCompanyChangeNothing) {
  const auto scene = load_scene("paper");
  expect_the_same(sampled(with_schemes(scene, {"lie_euler"}), 1),
                  sampled(with_schemes(scene, {"lie_euler", "strang"}), 3), "lie_euler");
}

TEST(SampledExponents, WithoutAnExactValueNothingIsCompared) {
  const auto s = with_schemes(load_scene("paper"), {"lie_euler"});
  const context c{s, effort::quick, 2};
  report::results out;
  report_sampled_exponents(c, s.schemes, {.reason = "not known"}, out);
  int open = 0;
  for (const auto& v : out.verdicts) {
    if (v.claim.starts_with("finds")) {
      EXPECT_EQ(v.kind, verdict_kind::inconclusive) << v.claim;
      ++open;
    }
  }
  EXPECT_EQ(open, 1);
  EXPECT_NE(row_of(out, "lambda_1"), nullptr);
}

report::results held_against(const subject& s, const discretisation_growth& own) {
  const context c{s, effort::quick, 2};
  report::results out;
  report_sampled_exponents(c, s.schemes, lyapunov(*s.sphere(), 1e-5), out,
                           [&] { return known_growths(s.schemes.size(), own); });
  return out;
}

// What is known of a scheme decides in place of its paths, and they see where it is not so.
TEST(SampledExponents, PathsAreHeldAgainstWhatIsKnownWithoutThem) {
  const auto s = with_schemes(load_scene("paper"), {"lie_euler"});
  const auto value = make_frame_transfer(s, s.schemes[0], compared_step(s), {{10, 1, 0}, {5, 2}}).exponents();
  const discretisation_growth own{value, Eigen::Vector2d::Constant(1e-6)};
  const auto right = held_against(s, own);
  EXPECT_EQ(verdict_kind_of(right, "lie_euler", "finds lambda_1"), verdict_kind::holds);
  EXPECT_EQ(verdict_kind_of(right, "lie_euler", "controls have mean zero"), verdict_kind::holds);
  EXPECT_EQ(*row_of(right, "lambda_1")->value, value[0]);
  const auto* simulated = row_of(right, "lambda_1, simulated");
  ASSERT_TRUE(simulated);
  const double width = *simulated->high - *simulated->low;
  for (const Eigen::Index k : {0, 1}) {
    auto wrong = own;
    wrong.value[k] += 3 * width;
    EXPECT_EQ(verdict_kind_of(held_against(s, wrong), "lie_euler", "controls have mean zero"), verdict_kind::refuted) << k;
  }
  auto uncertain = own;
  uncertain.uncertainty[1] = 1;  // of no use: paths decide
  EXPECT_EQ(row_of(held_against(s, uncertain), "lambda_1, simulated"), nullptr);
}

TEST(SampledExponents, AStartThatIsNotForgottenIsNotTriedAndSaysAtWhichEffortItIs) {
  const auto s = with_schemes(load_scene("single"), {"lie_euler"});
  const context c{s, effort::quick, 2};
  report::results r;
  report_sampled_exponents(c, s.schemes, {.reason = "not asked for"}, r);
  ASSERT_EQ(r.verdicts.size(), 1u);
  EXPECT_EQ(r.verdicts[0].kind, verdict_kind::not_tried);
  EXPECT_NE(r.verdicts[0].reason.find("tried at effort thorough"), std::string::npos) << r.verdicts[0].reason;
  EXPECT_TRUE(r.measurements.empty());
}

}  // namespace
}  // namespace polhode
