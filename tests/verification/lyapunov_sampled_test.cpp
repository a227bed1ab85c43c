// The sampled exponents of the schemes: known answers, defects that only they can see, and bits that do not depend on
// threads or company.
#include "experiments/lyapunov_sampled.hpp"

#include <gtest/gtest.h>

#include "experiments/transfer.hpp"
#include "registry/bind.hpp"
#include "registry/rigid_body.hpp"
#include "registry/run_experiment.hpp"
#include "registry/scene.hpp"
#include "registry/systems.hpp"

namespace polhode {
namespace {

using report::verdict_kind;

report::results sampled(const subject& s, int threads = 2) {
  const context c{s, effort::quick, threads};
  report::results out;
  report_sampled_exponents(c, lyapunov(*sphere_problem_of(s), 1e-5), out);
  return out;
}

subject with_schemes(const report::scene& scene, const std::vector<std::string>& schemes) {
  return restricted(bind_rigid_body(scene), schemes);
}

report::scene paper_with(double theta) {
  auto scene = load_scene("paper");
  scene.theta = theta;
  return scene;
}

verdict_kind verdict_of(const report::results& r, std::string_view scheme, std::string_view claim) {
  for (const auto& v : r.verdicts)
    if (v.scheme == scheme && v.claim == claim) return v.kind;
  return verdict_kind::skipped;
}

const report::measurement* row_of(const report::results& r, std::string_view quantity) {
  for (const auto& m : r.measurements)
    if (m.quantity == quantity) return &m;
  return nullptr;
}

void expect_row(const report::results& r, std::string_view quantity, double exact) {
  const auto* m = row_of(r, quantity);
  ASSERT_TRUE(m && m->value && m->dt) << quantity;
  EXPECT_NEAR(*m->value, exact, 1e-3) << quantity;
  EXPECT_LT(*m->high - *m->low, 2e-3) << quantity;
}

// MODEL, section 5: the sign of lambda_1 changes between theta = 1/2 and 1.
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
report::results of_mutant(const report::scene& scene) {
  return sampled(bind(scene, make_rigid_body, scheme_list<Scheme>{}));
}

TEST(SampledExponents, AWrongTangentIsRefuted) {
  const auto r = of_mutant<generator_frozen_in_the_tangent>(load_scene("paper"));
  EXPECT_EQ(verdict_of(r, "generator_frozen_in_the_tangent", "finds lambda_1"), verdict_kind::refuted);
  EXPECT_EQ(verdict_of(r, "generator_frozen_in_the_tangent", "finds lambda_1 + lambda_2"), verdict_kind::refuted);
}

// (With isotropic noise that drift is radial, and the projection takes it out.)
TEST(SampledExponents, TheWrongEquationIsRefuted) {
  auto scene = load_scene("paper");
  scene.sigma = {{0.3, 0, 0}, {0, 0.5, 0}, {0, 0, 0.7}};
  const auto r = of_mutant<ito_drift_added>(scene);
  EXPECT_EQ(verdict_of(r, "ito_drift_added", "finds lambda_1 + lambda_2"), verdict_kind::refuted);
}

TEST(SampledExponents, ThreadsAndCompanyChangeNothing) {
  const auto scene = load_scene("paper");
  const auto alone = sampled(with_schemes(scene, {"lie_euler"}), 1),
             beside = sampled(with_schemes(scene, {"lie_euler", "strang"}), 3);
  std::size_t same = 0;
  for (const auto& m : beside.measurements) {
    if (m.scheme != "lie_euler") continue;
    ASSERT_LT(same, alone.measurements.size());
    const auto& other = alone.measurements[same++];
    EXPECT_EQ(m.value, other.value) << m.quantity;
    EXPECT_EQ(m.low, other.low) << m.quantity;
  }
  EXPECT_EQ(same, alone.measurements.size());
}

TEST(SampledExponents, WithoutAnExactValueNothingIsCompared) {
  const auto s = with_schemes(load_scene("paper"), {"lie_euler"});
  const context c{s, effort::quick, 2};
  report::results out;
  report_sampled_exponents(c, {.reason = "not known"}, out);
  EXPECT_TRUE(out.verdicts.empty());
  EXPECT_FALSE(out.skipped.empty());
  EXPECT_NE(row_of(out, "lambda_1"), nullptr);
}

TEST(SampledExponents, AStartThatIsNotForgottenIsSkippedWithTheReason) {
  const auto s = with_schemes(load_scene("single"), {"lie_euler"});
  const context c{s, effort::quick, 2};
  report::results r;
  report_sampled_exponents(c, {.reason = "not asked for"}, r);
  ASSERT_EQ(r.skipped.size(), 1u);
  EXPECT_NE(r.skipped[0].reason.find("remembered"), std::string::npos);
  EXPECT_TRUE(r.measurements.empty());
}

}  // namespace
}  // namespace polhode
