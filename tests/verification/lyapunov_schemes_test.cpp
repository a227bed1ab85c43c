// The exponents of the schemes, sampled and not: known answers, each other, defects that only they can see, and bits
// that do not depend on threads or on the batch.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "experiments/common/levels.hpp"
#include "experiments/lyapunov/discretisation_exponents.hpp"
#include "experiments/lyapunov/lyapunov_sampled.hpp"
#include "experiments/lyapunov/tangent_runs.hpp"
#include "platform/isa.hpp"
#include "run/run_experiment.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "systems/bind.hpp"
#include "systems/rigid_body/rigid_body.hpp"
#include "transfer/frame_transfer.hpp"
#include "transfer/transfer.hpp"

namespace polhode {
namespace {

using report::verdict_kind;

report::results sampled(const subject& s, int threads = 2) {
  const context c{s, effort::quick, threads};
  report::results out;
  report_sampled_exponents(c, s.schemes, lyapunov(*s.sphere(), 1e-5), out);
  return out;
}

report::results own(const subject& s, int threads = 2) {
  const context c{s, effort::quick, threads};
  report::results out;
  report_discretisation_exponents(c, s.schemes, lyapunov(*s.sphere(), 1e-10), out);
  return out;
}

subject with_schemes(const report::scene& scene, const std::vector<std::string>& schemes) {
  return restricted(bind_scene(scene), schemes);
}

report::scene paper_with(double theta) {
  auto scene = load_scene("paper");
  scene.number("theta") = theta;
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

TEST(SampledExponents, AWrongTangentIsRefuted) {
  const auto r = sampled(with_mutant<generator_frozen_in_the_tangent>(load_scene("paper")));
  EXPECT_EQ(verdict_of(r, "generator_frozen_in_the_tangent", "finds lambda_1"), verdict_kind::refuted);
  EXPECT_EQ(verdict_of(r, "generator_frozen_in_the_tangent", "finds lambda_1 + lambda_2"), verdict_kind::refuted);
}

// (With isotropic noise that drift is radial, and the projection takes it out.)
report::scene paper_with_unequal_noise() {
  auto scene = load_scene("paper");
  scene.vectors("sigma") = {{0.3, 0, 0}, {0, 0.5, 0}, {0, 0, 0.7}};
  return scene;
}

TEST(SampledExponents, TheWrongEquationIsRefuted) {
  const auto r = sampled(with_mutant<ito_drift_added>(paper_with_unequal_noise()));
  EXPECT_EQ(verdict_of(r, "ito_drift_added", "finds lambda_1 + lambda_2"), verdict_kind::refuted);
}

/// What is said of a scheme alone is what is said of it beside others.
void expect_the_same(const report::results& alone, const report::results& beside, std::string_view scheme) {
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
  EXPECT_EQ(verdict_of(right, "lie_euler", "finds lambda_1"), verdict_kind::holds);
  EXPECT_EQ(verdict_of(right, "lie_euler", "controls have mean zero"), verdict_kind::holds);
  EXPECT_EQ(*row_of(right, "lambda_1")->value, value[0]);
  const auto* simulated = row_of(right, "lambda_1, simulated");
  ASSERT_TRUE(simulated);
  const double width = *simulated->high - *simulated->low;
  for (const Eigen::Index k : {0, 1}) {
    auto wrong = own;
    wrong.value[k] += 3 * width;
    EXPECT_EQ(verdict_of(held_against(s, wrong), "lie_euler", "controls have mean zero"), verdict_kind::refuted) << k;
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

constexpr auto order_claim = "order of the exponents";

TEST(OwnExponents, ConvergeToThoseOfTheEquation) {
  const auto r = own(with_schemes(load_scene("paper"), {"implicit_midpoint", "strang_weak2"}));
  ASSERT_EQ(r.verdicts.size(), 2u);
  for (const auto& v : r.verdicts) EXPECT_EQ(v.kind, verdict_kind::holds) << v.scheme << ": " << v.reason;
  EXPECT_NEAR(*r.verdicts.back().estimate, 2, 0.02);
}

TEST(OwnExponents, AWrongTangentIsRefuted) {
  const auto r = own(with_mutant<generator_frozen_in_the_tangent>(load_scene("paper")));
  EXPECT_EQ(verdict_of(r, "generator_frozen_in_the_tangent", order_claim), verdict_kind::refuted);
}
TEST(OwnExponents, TheWrongEquationIsRefuted) {
  const auto r = own(with_mutant<ito_drift_added>(paper_with_unequal_noise()));
  EXPECT_EQ(verdict_of(r, "ito_drift_added", order_claim), verdict_kind::refuted);
}

TEST(OwnExponents, ThreadsAndCompanyChangeNothing) {
  const auto scene = load_scene("anisotropic");
  expect_the_same(own(with_schemes(scene, {"cayley_heun"}), 1), own(with_schemes(scene, {"cayley_heun", "magnus"}), 3),
                  "cayley_heun");
}

/// Mean and standard error of what paths of a scheme stretch.
struct sampled_pair {
  double mean, error;
};
sampled_pair mean_of(const Eigen::VectorXd& x) {
  const double mean = x.mean(), n = static_cast<double>(x.size());
  return {mean, std::sqrt((x.array() - mean).square().sum() / (n * (n - 1)))};
}

// Schemes of every kind at a step where their exponents are far from those of the equation; noise of any kind.
TEST(OwnExponents, AreWhatSampledPathsDo) {
  auto scene = load_scene("paper");
  scene.vectors("sigma") = {{0.3, 0.1, 0}, {-0.2, 0.4, 0.1}, {0, 0.3, 0.2}};
  const auto s = with_schemes(scene, {"lie_euler", "implicit_midpoint", "strang", "magnus", "heun_projected"});
  ASSERT_EQ(s.schemes.size(), 5u);
  const context c{s, effort::quick, 1};
  constexpr double dt = 0.25;
  constexpr int blocks = 24;
  for (const auto& scheme : s.schemes) {
    const auto kernel = scheme.tangent(dt);
    growth found(blocks * block_lanes);
    growth* const out[]{&found};
    const tangent_kernel* const kernels[]{kernel.get()};
    for (int block = 0; block < blocks; ++block)
      run_tangents(c, run_length_of(dt, 30, 400), block, kernels, scheme.needs_areas, out);
    const auto exponents = make_frame_transfer(s, scheme, dt, {{10, 1, 0}, {5, 2}}).exponents();
    const auto length = mean_of(found.length), area = mean_of(found.area);
    EXPECT_LT(length.error, 6e-4);
    EXPECT_NEAR(exponents[0], length.mean, 4 * length.error) << scheme.info.name;
    EXPECT_NEAR(exponents[1], area.mean, 4 * area.error) << scheme.info.name;
  }
}

// A rotation by a normal vector is a class function: E[D^l] = E[sin((2l+1) f/2) / sin(f/2)] / (2l+1) times the
// identity, f the angle (Peter and Weyl).
std::vector<double> means_over_rotations(double sigma, double dt, int degree) {
  std::vector<double> out;
  for (int l = 0; l <= degree; ++l) {
    double sum = 0;  // 1 + 2 sum E[cos k f], f^2 = sigma^2 dt chi^2_3
    for (int k = -l; k <= l; ++k) {
      const double variance = k * k * sigma * sigma * dt;
      sum += (1 - variance) * std::exp(-variance / 2);
    }
    out.push_back(sum / (2 * l + 1));
  }
  return out;
}

TEST(FrameTransfer, OfNoiseAloneIsAMultipleOfTheIdentityInEachDegree) {
  constexpr double sigma = 0.5, dt = 0.25;
  constexpr int degree = 6;
  auto scene = load_scene("undamped");
  scene.vector("inertia") = {1e13, 1e13, 1e13};
  ASSERT_EQ(scene.vectors("sigma")[0][0], sigma);
  const auto expected = means_over_rotations(sigma, dt, degree);
  for (const isa level : usable_isas()) {
    choose_isa(level);
    const auto s = with_schemes(scene, {"lie_euler"});
    const auto op = make_frame_transfer(s, s.schemes[0], dt, {{degree, 1, 0}, {13, 2}});
    Eigen::MatrixXd rest = op.matrix;
    Eigen::Index i = 0;
    for (int n = 0; n <= degree; n += 2)
      for (int m = n == 0 ? 0 : -degree; m <= degree; ++m)
        for (int l = std::max(std::abs(m), n); l <= degree; ++l)
          for (int part = 0; part < (m == 0 && n == 0 ? 1 : 2); ++part, ++i)
            rest(i, i) -= expected[static_cast<std::size_t>(l)];
    ASSERT_EQ(i, rest.rows());
    EXPECT_LT(rest.cwiseAbs().maxCoeff(), 1e-11) << name_of(level);
    EXPECT_LT(op.exponents().cwiseAbs().maxCoeff(), 1e-10) << name_of(level);
  }
  choose_isa(usable_isas().back());
}

}  // namespace
}  // namespace polhode
