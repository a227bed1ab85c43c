// Which equation a scheme solves: known answers, and defects that have to be refuted.
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

#include "algebra/logarithm_action.hpp"
#include "experiments/modified/ergodic_variance.hpp"
#include "experiments/modified/leading_constants.hpp"
#include "experiments/modified/modified_constants.hpp"
#include "experiments/modified/modified_steps.hpp"
#include "experiments/modified/modified_table.hpp"
#include "experiments/modified/modified_verdict.hpp"
#include "run/run_experiment.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "support/dense.hpp"
#include "transfer/transfer.hpp"

namespace polhode {
namespace {

scheme_entry scheme_of(const subject& s, std::string_view name) {
  return *std::ranges::find(s.schemes, name, [](const scheme_entry& e) { return e.info.name; });
}

nearest_body effective(std::string_view scheme, double dt) {
  const auto s = bind_scene(load_scene("paper"));
  const auto op = make_transfer(s, scheme_of(s, scheme), dt, 1, {{12, 1, 0}, {8, 2}});
  return generator_family(sphere_problem_of(s)->radius).nearest(*generator_of_step(op.matrix, dt));
}

struct known {
  const char* scheme;
  double dt;
  Eigen::Vector3d k, theta_k, q;
  double residual, digits;  // of the residual
};

// Written apart from this project (numpy, dense logarithm), to four decimals; MODEL.md, section 10.
TEST(Modified, EffectiveParametersAreTheKnownOnes) {
  for (const auto& a : {known{"lie_euler",
                              0.1,
                              {0.4054, -0.1152, -0.2902},
                              {0.1930, -0.0580, -0.1351},
                              {0.2526, 0.2498, 0.2491},
                              1.67e-2,
                              1e-4},
                        known{"lie_euler",
                              0.05,
                              {0.3971, -0.1131, -0.2840},
                              {0.1938, -0.0567, -0.1370},
                              {0.2513, 0.2500, 0.2496},
                              8.3e-3,
                              1e-4},
                        known{"strang_weak2",
                              0.1,
                              {0.3890, -0.1111, -0.2779},
                              {0.1947, -0.0556, -0.1391},
                              {0.2500, 0.2500, 0.2499},
                              2.7e-4,
                              1e-5}}) {
    const auto body = effective(a.scheme, a.dt);
    EXPECT_LT((body.parameters.inverse_inertia - a.k).cwiseAbs().maxCoeff(), 6e-5) << a.scheme << ' ' << a.dt;
    EXPECT_LT((body.parameters.dissipation - a.theta_k).cwiseAbs().maxCoeff(), 6e-5) << a.scheme << ' ' << a.dt;
    EXPECT_LT((body.parameters.noise.diagonal() - a.q).cwiseAbs().maxCoeff(), 6e-5) << a.scheme << ' ' << a.dt;
    EXPECT_NEAR(body.residual, a.residual, a.digits) << a.scheme << ' ' << a.dt;
  }
}

sphere_problem general_problem() {
  auto p = body_on_sphere({0.7, 1.9, 2.6}, 0.3, 1.4, Eigen::Matrix3d::Zero());
  p.covariance << 0.5, 0.1, -0.05, 0.1, 0.3, 0.08, -0.05, 0.08, 0.4;
  return p;
}

TEST(Modified, TheFamilyHoldsItsOwnGenerators) {
  const auto p = general_problem();
  const Eigen::MatrixXd generator = backward_operator(p, 8);
  const auto body = generator_family(p.radius).nearest(generator.middleCols(1, 8));
  const auto exact = parameters_of(p);
  EXPECT_LT((body.parameters.inverse_inertia - exact.inverse_inertia).norm(), 1e-13);
  EXPECT_LT((body.parameters.dissipation - exact.dissipation).norm(), 1e-13);
  EXPECT_LT((body.parameters.noise - exact.noise).norm(), 1e-13);
  EXPECT_LT(body.residual, 1e-14);
}

// Where the principal logarithm of the whole matrix exists, Krylov's method finds its columns.
TEST(Modified, LogarithmIsTheDenseOne) {
  const Eigen::MatrixXd generator = backward_operator(general_problem(), 6);
  const Eigen::MatrixXd step = test::exponential_of(0.05 * generator), whole = test::logarithm_of(step);
  const auto columns = logarithm_action(step, Eigen::MatrixXd::Identity(step.rows(), 9));
  ASSERT_TRUE(columns);
  EXPECT_LT((*columns - whole.leftCols(9)).norm(), 1e-11 * whole.norm());
  EXPECT_LT((*columns - 0.05 * generator.leftCols(9)).norm(), 1e-11 * generator.norm());
  const Eigen::MatrixXd reflection = -Eigen::MatrixXd::Identity(4, 4);
  EXPECT_FALSE(logarithm_action(reflection, Eigen::MatrixXd::Identity(4, 4)));
  EXPECT_FALSE(logarithm_action(Eigen::MatrixXd::Constant(4, 4, NAN), Eigen::MatrixXd::Identity(4, 4)));
}

report::results quick(const subject& s) {
  verify_options options;
  options.experiments = {"modified"};
  options.effort = effort::quick;
  options.threads = 2;
  return verify_subject(s, options);
}

const report::verdict& verdict_of(const report::results& r, std::string_view claim) {
  return *std::ranges::find(r.verdicts, claim, &report::verdict::claim);
}
constexpr std::string_view parameters = "parameters converge to the scene's",
                           residual = "residual falls at the weak order";

using change = void (*)(report::scene&);

/// The scheme as it is on one scene, held to another: what a wrong number in its code would be.
subject planted(const report::scene& scene, std::string_view scheme, change wrong) {
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

struct defect {
  const char *name, *scheme;
  change wrong;
};
void PrintTo(const defect& d, std::ostream* out) { *out << d.name << ", " << d.scheme; }

struct ModifiedDefects : testing::TestWithParam<defect> {};

TEST_P(ModifiedDefects, AreRefuted) {
  const auto r = quick(planted(load_scene("paper"), GetParam().scheme, GetParam().wrong));
  EXPECT_EQ(verdict_of(r, parameters).kind, report::verdict_kind::refuted) << verdict_of(r, parameters).reason;
}

constexpr change noise_strong = stronger_noise<1>, noise_weak = stronger_noise<-1>,
                 theta_large = [](report::scene&s) { s.number("theta") *= 1.001; },
                 inertia_one = [](report::scene&s) { s.vector("inertia")[0] *= 1.01; },
                 inertia_two = [](report::scene&s) { s.vector("inertia")[1] *= 0.999; },
                 inertia_three = [](report::scene&s) { s.vector("inertia")[2] *= 1.001; },
                 turned_noise = [](report::scene&s) {
                   s.vectors("sigma")[0] = {0.5, 0.0005, 0};
                 };

INSTANTIATE_TEST_SUITE_P(Planted, ModifiedDefects,
                         testing::Values(defect{"noise 0.1 % strong", "lie_euler", noise_strong},
                                         defect{"noise 0.1 % strong", "strang_weak2", noise_strong},
                                         defect{"noise 0.1 % weak", "lie_euler", noise_weak},
                                         defect{"noise 0.1 % weak", "strang_weak2", noise_weak},
                                         defect{"theta 0.1 % large", "lie_euler", theta_large},
                                         defect{"theta 0.1 % large", "strang_weak2", theta_large},
                                         defect{"I_1 1 % large", "lie_euler", inertia_one},
                                         defect{"I_1 1 % large", "strang_weak2", inertia_one},
                                         defect{"I_2 0.1 % small", "lie_euler", inertia_two},
                                         defect{"I_2 0.1 % small", "strang_weak2", inertia_two},
                                         defect{"I_3 0.1 % large", "lie_euler", inertia_three},
                                         defect{"I_3 0.1 % large", "strang_weak2", inertia_three},
                                         defect{"channels correlated by 0.001", "lie_heun", turned_noise},
                                         defect{"channels correlated by 0.001", "implicit_midpoint", turned_noise}));

// Weak noise hides dt behind dt^2 in every slope; the coefficient of dt is seen all the same.
// At sigma = 0.05 among the planted defects of the nightly table.
TEST(Modified, WeakOrderTwoOverclaimedIsRefutedUnderWeakNoise) {
  auto scene = load_scene("paper");
  scene.vectors("sigma") = {{0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}};
  auto s = bind_scene(scene);
  const auto healthy = scheme_of(s, "strang_weak2");
  auto poser = scheme_of(s, "strang");
  poser.info = healthy.info;
  s.schemes = {poser};
  const auto r = quick(s);
  EXPECT_EQ(verdict_of(r, parameters).kind, report::verdict_kind::refuted) << verdict_of(r, parameters).reason;
  s.schemes = {healthy};
  const auto of_healthy = quick(s);
  for (const auto claim : {parameters, residual})
    EXPECT_EQ(verdict_of(of_healthy, claim).kind, report::verdict_kind::holds) << claim;
}

/// The constants of a driver that takes `off` steps too many, over a share of the horizon.
report::verdict constants_of(std::string_view name, std::int64_t off, double share) {
  const auto s = bind_scene(load_scene("paper"));
  const auto scheme = scheme_of(s, name);
  const auto averages = averages_on(s);
  const int order = static_cast<int>(scheme.info.weak_order.isotropic);
  error_table t{std::string(name), {}, {}, {}};
  const auto grid = modified_levels(s);
  for (const int steps : grid.steps) {
    const double dt = grid.horizon / steps;
    const auto op = make_transfer(s, scheme, share * dt, 1, {{16, 1, 0}, {7, 2}});
    const Eigen::VectorXd found = averages.of(op, Eigen::Vector3d(s.scene.momentum.data()), steps + off);
    t.add(dt, {found - averages.value(),
               averages.uncertainty() + (1e-12 + 1e-8 * std::pow(dt, order)) * averages.size(), true});
  }
  const double rate = fastest_rate(s);
  const std::vector<double> dt{1 / (16 * rate), 1 / (32 * rate), 1 / (64 * rate), 1 / (128 * rate)};
  const expansion_frame coarse(s, averages, 12, dt), fine(s, averages, 16, dt);
  const auto predicted = predicted_constants(s, scheme, averages, coarse, fine, order);
  return judge_constants({"modified", std::string(name), ""},
                         leading_constants(averages.at_horizon, t, 0, predicted, order), order, rate);
}

TEST(LeadingConstants, DriversThatMiscountAreRefuted) {
  for (const auto* scheme : {"lie_euler", "strang_weak2"}) {
    const auto healthy = constants_of(scheme, 0, 1);
    EXPECT_EQ(healthy.kind, report::verdict_kind::holds) << scheme << ": " << healthy.reason;
    EXPECT_NEAR(*healthy.estimate, *healthy.expected, 1e-5 * std::fabs(*healthy.expected));
    for (const std::int64_t off : {-1, 1})
      EXPECT_EQ(constants_of(scheme, off, 1).kind, report::verdict_kind::refuted) << scheme << ' ' << off;
    EXPECT_EQ(constants_of(scheme, 0, 0.99).kind, report::verdict_kind::refuted) << scheme;
  }
}

/// Strong noise about one axis: by all levels the error of Pi_1 does not vanish with dt, by a sixth of its certainty.
TEST(LeadingConstants, WhatOneRuleOfTwoFindsIsNoRefutation) {
  auto scene = load_scene("paper");
  scene.vector("inertia") = {3.2258025755885602, 0.65497060247249972, 0.78447667770932794};
  scene.number("theta") = 0.31399547462472188;
  scene.momentum = {0.61723509863248949, 0.47148945507866363, 0.066032148277920241};
  scene.vectors("sigma") = {{-1.8052490067401659, 0, 0}, {0, 0.41100541459169243, 0}, {0, 0, 0.48681560896093712}};
  for (const auto& v : quick(restricted(bind_scene(scene), {"strang_weak2"})).verdicts)
    EXPECT_NE(v.kind, report::verdict_kind::refuted) << v.claim << ": " << v.reason;
}

// A spherical body under isotropic noise: one exponential of the Gaussian vector has log(T)/dt = sigma^2 L^2/2 + dt
// sigma^4 L^2/24 + … on every degree (MODEL.md, section 2), and L^2 = -2 on the first: the rate of Pi_1 is off by
// -sigma^4 dt/12.
TEST(LeadingConstants, OfASphericalBodyAreKnown) {
  auto scene = load_scene("paper");
  scene.vector("inertia") = {1, 1, 1};
  scene.number("theta") = 0;
  const auto s = bind_scene(scene);
  const auto averages = averages_on(s);
  const double rate = fastest_rate(s), sigma2 = 0.25;
  const std::vector<double> dt{1 / (16 * rate), 1 / (32 * rate), 1 / (64 * rate), 1 / (128 * rate)};
  const expansion_frame coarse(s, averages, 8, dt), fine(s, averages, 12, dt);
  const auto found = predicted_constants(s, scheme_of(s, "lie_euler"), averages, coarse, fine, 1);
  const auto pi1 =
      static_cast<std::size_t>(std::ranges::find(averages.at_horizon.names, "pi1") - averages.at_horizon.names.begin());
  const double exact = -2 * sigma2 * sigma2 / 12 * std::exp(-2 * sigma2) * 0.6;  // T = 2
  EXPECT_NEAR(found[pi1].value, exact, 1e-6 * std::fabs(exact)) << found[pi1].low << ' ' << found[pi1].high;
}

// Isotropic noise alone: degree one is one eigenspace, of the equation with -sigma^2 and of a rotation by sigma
// sqrt(dt) g with (1 + 2 E cos)/3, E cos |sigma sqrt(dt) g| = (1 - s) exp(-s/2), s = sigma^2 dt;
// of a spherical body strang does nothing else.
TEST(ErgodicVariance, OfASphericalBodyIsKnown) {
  auto scene = load_scene("paper");
  scene.vector("inertia") = {1, 1, 1};
  scene.number("theta") = 0;
  const auto s = bind_scene(scene);
  const double sigma2 = 0.25, dt = 0.125, share = sigma2 * dt;
  exact_averages one{{"pi1"}, {*named_observable("pi1", *sphere_problem_of(s))}, {}, {}, {}};
  one.value = one.uncertainty = one.size = Eigen::VectorXd::Ones(1);
  law_averages averages;
  averages.stationary = one;
  EXPECT_NEAR(ergodic_variances(s, averages).value[0], 2.0 / 3 / sigma2, 1e-12);
  const auto op = make_transfer(s, scheme_of(s, "strang"), dt, 1, {{12, 1, 0}, {9, 2}});
  const double factor = (1 + 2 * (1 - share) * std::exp(-share / 2)) / 3;
  EXPECT_NEAR(ergodic_variances(one, op, sum_of_powers(op), dt)[0], dt / 3 * (1 + factor) / (1 - factor), 1e-10);
}

// A clock that is one per cent slow leaves the stationary law alone, and not the variance.
TEST(ErgodicVariance, ASlowClockIsRefuted) {
  auto s = bind_scene(load_scene("paper"));
  auto scheme = scheme_of(s, "lie_heun");
  auto scene = s.scene;
  for (auto& v : scene.vectors("sigma"))
    for (auto& x : v) x *= std::sqrt(0.99);
  for (auto& x : scene.vector("inertia")) x /= 0.99;
  const auto slow = bind_scene(scene);  // theta k by 0.99, too: the same law
  s.schemes = {scheme_of(slow, "lie_heun")};
  const auto r = quick(s);
  EXPECT_EQ(verdict_of(r, "asymptotic variance converges").kind, report::verdict_kind::refuted);
  s.schemes = {scheme};
  EXPECT_EQ(verdict_of(quick(s), "asymptotic variance converges").kind, report::verdict_kind::holds);
}

/// Leaves out the last step of every run of more than one.
class forgetful final : public kernel {
 public:
  explicit forgetful(std::unique_ptr<kernel> k) : k_(std::move(k)) {}
  void advance(std::span<double> states, const increment_view& v, piece p) const override {
    auto fewer = v;
    if (v.steps > 1) --fewer.steps;
    k_->advance(states, fewer, p);
  }
  shared_steps share(const increment_view& v) const override { return k_->share(v); }
  void advance(std::span<double> states, const shared_steps& v, std::int64_t first, std::int64_t steps,
               piece p) const override {
    k_->advance(states, v, first, steps, p);
  }
  void finish(std::span<double> states, double dt) const override { k_->finish(states, dt); }

 private:
  std::unique_ptr<kernel> k_;
};

TEST(Modified, ALoopThatLeavesOutItsLastStepIsRefuted) {
  auto s = bind_scene(load_scene("paper"));
  for (auto scheme : s.schemes) {
    EXPECT_EQ(judge_steps({s}, scheme).kind, report::verdict_kind::holds) << judge_steps({s}, scheme).reason;
    scheme.make = [inner = scheme.make](double dt) { return std::make_unique<forgetful>(inner(dt)); };
    EXPECT_EQ(judge_steps({s}, scheme).kind, report::verdict_kind::refuted) << scheme.info.name;
  }
}

// Weak noise along two axes: the averages need degrees beyond what quick affords.
TEST(Modified, AveragesOfHighDegreeAreNotTriedAndSayAtWhichEffortTheyAre) {
  auto s = bind_scene(load_scene("anisotropic"));
  law_averages averages;
  averages.at_horizon = {{"pi1"},
                         {*named_observable("pi1", *sphere_problem_of(s))},
                         Eigen::VectorXd::Ones(1),
                         Eigen::VectorXd::Zero(1),
                         Eigen::VectorXd::Ones(1),
                         32};
  averages.stationary = averages.at_horizon;
  const auto said = [&](effort e, int degree) {
    auto kept = averages;
    kept.at_horizon.degree = kept.stationary.degree = degree;
    report::results out;
    keep_affordable({s, e, 1}, {scheme_of(s, "strang")}, kept, out);
    EXPECT_EQ(kept.at_horizon.count() == 0, out.verdicts.size() == 3) << degree;
    return out.verdicts.empty() ? report::verdict_kind::holds : out.verdicts[0].kind;
  };
  EXPECT_EQ(said(effort::quick, 24), report::verdict_kind::holds);
  EXPECT_EQ(said(effort::quick, 32), report::verdict_kind::not_tried);
  EXPECT_EQ(said(effort::standard, 32), report::verdict_kind::holds);
  EXPECT_EQ(said(effort::quick, 128), report::verdict_kind::inconclusive);
}

TEST(Modified, HealthySchemesHoldAndThoseOffTheSphereAreSkipped) {
  const auto r = quick(bind_scene(load_scene("paper")));
  int holding = 0, skipped = 0;
  for (const auto& v : r.verdicts) {
    holding += v.kind == report::verdict_kind::holds;
    skipped += v.kind == report::verdict_kind::skipped;
  }
  EXPECT_EQ(holding, 14 + 6 * 10);
  EXPECT_EQ(skipped, 4);
  EXPECT_EQ(r.verdicts.size(), 14u + 6 * 10 + 4);
}

}  // namespace
}  // namespace polhode
