// SPDX-License-Identifier: Apache-2.0
// Lyapunov exponents off the sphere: held to the exact ones of single bodies and to the Gibbs law of the top, and what
// the experiments say of tangents that are wrong and of bodies that leave.
#include "experiments/lyapunov/orbit_exponents.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "ensemble/noise/paths.hpp"
#include "experiments/attractor/attractor_orbit.hpp"
#include "experiments/common/judge.hpp"
#include "experiments/lyapunov/orbit_runs.hpp"
#include "experiments/lyapunov/orbit_verdicts.hpp"
#include "run/bind_scene.hpp"
#include "run/run_experiment.hpp"
#include "scene/scene.hpp"
#include "support/kernel_decorator.hpp"
#include "support/verdicts.hpp"

namespace polhode {
namespace {

using namespace test;
using report::verdict_kind;

constexpr const char *volume_claim = "sum of exponents is the mean divergence", *spectrum_claim = "finds the exponents";

/// Four standard errors of a mean, at which nothing true is missed.
void expect_mean(const Eigen::VectorXd& values, double exact, const char* what) {
  const auto found = mean_of(values);
  EXPECT_NEAR(found.value, exact, 4 / 1.96 * half_width(found)) << what;
  EXPECT_LT(half_width(found), 0.02) << what;
}

/// Two equal bodies without coupling, each that of docs/model.md, section 5, at theta = 1, sigma = 1/2.
report::scene bodies_apart() {
  auto scene = load_scene("so4");
  scene.vector("inertia") = {1, 2, 3, 1, 2, 3};
  scene.number("coupling") = 0;
  scene.number("theta") = 1;
  scene.momentum = {0.6, 0.48, 0.64, 0.6, 0.48, 0.64};
  return with_noise_times(scene, 0.5 / 0.3);
}

// Sums over both bodies, as two equal exponents of finite paths order themselves. Known answers: lambda_1 = -0.04358,
// lambda_1 + lambda_2 = -0.3056934656 (for each body).
TEST(OrbitExponents, OfBodiesWithoutCouplingAreThoseOfEach) {
  const auto s = restricted(bind_scene(bodies_apart()), {"strang_weak2"});
  const orbit_geometry orbit(*s.model, s.scene.momentum);
  const orbit_start start(*s.model, s.scene.momentum);
  constexpr int blocks = 3, forgetting = 200, observed = 800;
  constexpr double dt = 0.05;
  const auto flow = derivative_flow(s.schemes.front().tangent(dt));
  observed_rates found(blocks * block_lanes, 4);
  for (int block = 0; block < blocks; ++block) {
    const auto first = static_cast<std::uint64_t>(block) * block_lanes;
    orbit_block paths(orbit, start, 7, first, 4);
    increment_buffer noise(*s.model, orbit_block::chunk, false);
    for (std::uint64_t i = 0; i < forgetting + observed; ++i) {
      if (i == forgetting) paths.read();
      paths.advance(*flow, noise.fill(7, first, i * orbit_block::chunk, orbit_block::chunk, dt));
    }
    found.keep(block, paths.read());
  }
  expect_mean(found.rates.leftCols(2).rowwise().sum(), 2 * -0.04358, "the slow ones");
  expect_mean(found.rates.rightCols(2).rowwise().sum(), 2 * (-0.3056934656 + 0.04358), "the fast ones");
  expect_mean(found.volume, 2 * -0.3056934656, "volume");
  expect_mean(found.divergence, 2 * -0.3056934656, "divergence");
  // With dissipation they do not come in pairs that cancel.
  const Eigen::MatrixXd pairs = (found.rates + found.rates.rowwise().reverse()).leftCols(2);
  EXPECT_EQ(judge_all(pairs, 0.05, [](Eigen::Index) { return std::string(); }).kind, verdict_kind::refuted);
}

/// -theta E[sum_i V_i^2 h] under the Gibbs law of the scene heavy_top.
double exact_sum_of_the_top(const subject& s) {
  const double inverse[] = {1, 1 / 1.5, 1 / 2.2}, pull[] = {0.24, -0.32, 0.48};
  const double trace = inverse[0] + inverse[1] + inverse[2];
  const auto mean = [&](const std::string& name) { return s.offers->gibbs_mean(name)->value.value(); };
  double sum = trace;
  for (int k = 0; k < 3; ++k) {
    const auto of = std::to_string(k + 1);
    sum += (trace - 3 * inverse[k]) * mean("pi" + of + "^2") - inverse[k] * mean("gamma" + of + "^2") -
           2 * pull[k] * mean("gamma" + of);
  }
  return -dissipation_of(s.scene) * sum;
}

TEST(OrbitExponents, SumOfTheTopIsTheDivergenceUnderItsGibbsLaw) {
  const auto s = bind_scene(load_scene("heavy_top"));
  const context c{s, effort::quick, 2};
  const orbit_frame frame(c);
  noise_log log(*s.model, blocks_of(frame.paths));
  const auto found = observe_equation(c, frame, frame.vectors(), log);
  ASSERT_EQ(found.fault, "");
  expect_mean(found.divergence, exact_sum_of_the_top(s), "divergence");
  expect_mean(found.volume, exact_sum_of_the_top(s), "volume");
}

/// The states of one tangent kernel and the tangents of another.
class foreign_tangents final : public tangent_kernel {
 public:
  foreign_tangents(std::unique_ptr<tangent_kernel> own, std::unique_ptr<tangent_kernel> other)
      : own_(std::move(own)), other_(std::move(other)) {}
  double dt() const override { return own_->dt(); }
  void advance(std::span<double> states, std::span<double> tangents, const increment_view& view) const override {
    for (int i = 0; i < view.steps; ++i) {
      std::vector<double> there(states.begin(), states.end()), unused(tangents.begin(), tangents.end());
      other_->advance(there, tangents, view.part(i, 1));
      own_->advance(states, unused, view.part(i, 1));
    }
  }

 private:
  std::unique_ptr<tangent_kernel> own_, other_;
};

report::results exponents_of(const subject& s) { return test::quick_report(s, report_orbit_exponents); }

// The derivative of an equation with five per cent more dissipation.
TEST(OrbitExponents, AWrongTangentIsRefutedByTheDivergence) {
  auto s = restricted(bind_scene(load_scene("heavy_top")), {"strang_weak2"});
  const auto healthy = exponents_of(s);
  EXPECT_EQ(verdict_of(healthy, volume_claim).kind, verdict_kind::holds);
  EXPECT_EQ(verdict_of(healthy, spectrum_claim).kind, verdict_kind::holds);
  EXPECT_EQ(verdict_of(healthy, "finds the sign of lambda_1").kind, verdict_kind::holds);
  const auto more = s.with(with_dissipation(s.scene, 1.05 * dissipation_of(s.scene)));
  s.schemes.front().tangent = [own = s.schemes.front().tangent, other = more.schemes.front().tangent](double dt) {
    return std::make_unique<foreign_tangents>(own(dt), other(dt));
  };
  EXPECT_EQ(verdict_of(exponents_of(s), volume_claim).kind, verdict_kind::refuted);
}

TEST(OrbitExponents, ComeInPairsWithoutDissipation) {
  const auto r = exponents_of(restricted(bind_scene(load_scene("so4")), {"strang_weak2"}).without_dissipation());
  EXPECT_EQ(verdict_of(r, "exponents come in pairs").kind, verdict_kind::holds);
  EXPECT_EQ(verdict_of(r, volume_claim).kind, verdict_kind::holds);
  const auto divergence = std::ranges::find(r.measurements, "mean divergence", &report::measurement::quantity);
  ASSERT_NE(divergence, r.measurements.end());
  EXPECT_NEAR(*divergence->value, 0, 1e-11);
}

/// Every call takes the state off its orbit by 1e-12 of its size.
class leaving final : public kernel_decorator {
 public:
  using kernel_decorator::advance;
  using kernel_decorator::kernel_decorator;
  void advance(std::span<double> states, const increment_view& noise, piece p) const override {
    kernel_decorator::advance(states, noise, p);
    for (double& x : states) x *= 1 + 1e-12;
  }
};

report::results orbit_attractor_of(const subject& s) { return test::quick_report(s, report_orbit_attractor); }

TEST(OrbitAttractor, ABodyThatLeavesItsOrbitIsRefuted) {
  constexpr const char* stay = "bodies stay on the orbit";
  auto s = restricted(bind_scene(load_scene("maxwell_bloch")), {"strang"});
  const auto healthy = orbit_attractor_of(s);
  EXPECT_EQ(verdict_of(healthy, stay).kind, verdict_kind::holds);
  EXPECT_EQ(verdict_of(healthy, "neighbours meet or part at the rate lambda_1").kind, verdict_kind::holds);
  EXPECT_TRUE(healthy.densities.empty()) << "no vector of constant length";
  s.schemes.front().make = [inner = s.schemes.front().make](double dt) { return std::make_unique<leaving>(inner(dt)); };
  EXPECT_EQ(verdict_of(orbit_attractor_of(s), stay).kind, verdict_kind::refuted);
}

TEST(OrbitAttractor, IsNotAskedForWhereNothingGathers) {
  const auto top = bind_scene(load_scene("heavy_top"));
  EXPECT_FALSE(no_orbit_attractor(top));
  EXPECT_TRUE(no_orbit_attractor(top.without_noise()));
  EXPECT_TRUE(no_orbit_attractor(top.without_dissipation()));
}

TEST(OrbitExponents, AreNotAskedForWhereThereAreNone) {
  const auto top = bind_scene(load_scene("heavy_top"));
  EXPECT_FALSE(no_orbit_exponents(top));
  EXPECT_TRUE(no_orbit_exponents(top.without_noise()));
  EXPECT_TRUE(no_orbit_exponents(top.without_dissipation()));
  EXPECT_FALSE(no_orbit_exponents(bind_scene(load_scene("so4")).without_dissipation()));
}

}  // namespace
}  // namespace polhode
