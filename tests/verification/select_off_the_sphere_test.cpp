// SPDX-License-Identifier: Apache-2.0
// select where nothing is exact: what it samples against closed forms and against operators, and what it refuses.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

#include "experiments/common/levels.hpp"
#include "experiments/gibbs/long_runs.hpp"
#include "experiments/laws/law_errors.hpp"
#include "experiments/weak/weak_at_step.hpp"
#include "reports/model/errors.hpp"
#include "run/choose.hpp"
#include "run/run_experiment.hpp"
#include "support/verdicts.hpp"

namespace polhode {
namespace {

using report::verdict_kind;

constexpr int blocks = 64;

squared_errors room(int columns) {
  constexpr int paths = blocks * block_lanes;
  return {paths, columns, std::vector<double>(static_cast<std::size_t>(paths * columns))};
}

// Of two spins that nothing moves but noise of strength one lie_euler has the mean (1 + 2 (1 - s) exp(-s/2)) / 3, s =
// dt, on components after each step, in place of exp(-s).
TEST(SelectOffTheSphere, WeakErrorsAtAStepAreThoseOfTheRotation) {
  auto scene = load_scene("spin_pair");
  scene.vectors("quadratic") = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  scene.vector("field") = {0, 0, 0};
  scene.vectors("exchange") = {{0, 0}, {0, 0}};
  const auto s = bind_scene(with_dissipation(with_noise_times(scene, 2.5), 0));
  const std::vector<observable> f{{"s1_3", *observable_of(s, "s1_3")}};
  weak_at_step sampled({s, effort::standard, 2, 3}, 5, f, 0.25, 2, fastest_rate(s), blocks * block_lanes);
  auto found = room(sampled.columns());
  sampled.run(test::scheme_of(s, "lie_euler"), 0, blocks, found);
  found = sampled.controlled(found);
  ASSERT_EQ(sampled.times(), (std::vector{0.125, 0.25}));
  for (int look = 0; look < 2; ++look) {
    const double x = 0.125, mean = (1 + 2 * (1 - x) * std::exp(-x / 2)) / 3;
    const double exact = 0.8 * (std::pow(mean, look + 1) - std::exp(-x * (look + 1)));
    const auto m = level_mean(found, look);
    EXPECT_NEAR(m.mean, exact, 4 * m.error);
    EXPECT_LT(m.error, 0.15 * std::fabs(exact)) << "the noise is shared";
  }
}

/// The scene `spin`, as it is and as a chain of one.
std::array<subject, 2> a_spin_twice() {
  const auto alone = load_scene("spin");
  auto chain = load_scene("spin_pair");
  chain.number("count") = 1;
  chain.vectors("quadratic") = alone.vectors("quadratic");
  chain.vector("field") = alone.vector("field");
  chain.vectors("exchange") = {{0}};
  chain.vectors("sigma") = alone.vectors("sigma");
  chain.momentum = alone.momentum;
  return {bind_scene(alone), bind_scene(with_dissipation(chain, dissipation_of(alone)))};
}

TEST(SelectOffTheSphere, BiasesOfLongRunsAreThoseOfTheTransferOperator) {
  const auto [spin, chain] = a_spin_twice();
  ASSERT_FALSE(chain.sphere());
  const double dt = 1.5 / fastest_rate(spin);
  const equilibrium_law law(spin, 1e-10);
  const auto exact = law.error(test::scheme_of(spin, "lie_euler"), dt, 0.01);
  const long_runs sampled({chain, effort::standard, 2, 3}, observables_of(chain, 3));
  ASSERT_EQ(sampled.reason(), "");
  ASSERT_EQ(sampled.observables().size(), 7u);
  auto found = room(7);
  sampled.run(test::scheme_of(chain, "lie_euler"), dt, 7, 0, blocks, found);
  bool clear = false;
  for (int f = 0; f < 7; ++f) {  // energy, components and squares come first in both
    const auto m = level_mean(found, f);
    const double bias = std::fabs(exact.error[f]) * law.observables().size[f];
    EXPECT_NEAR(std::fabs(m.mean), bias, 4.5 * m.error) << law.observables().names[static_cast<std::size_t>(f)];
    clear = clear || bias > 10 * m.error;
  }
  EXPECT_TRUE(clear);
}

std::string fault_of(const scene& s, const char* goal, double tolerance, const char* observable = "all") {
  select_options o;
  o.goal = goal;
  o.tolerance = tolerance;
  o.observable = observable;
  try {
    select(s, o);
  } catch (const input_error& e) {
    return e.what();
  }
  return "";
}

TEST(SelectOffTheSphere, WhatSamplingCannotTellIsRefusedWithWhatItCan) {
  const auto so4 = load_scene("so4");
  for (const char* goal : {"weak", "stationary"}) {
    const auto fault = fault_of(so4, goal, 1e-6);
    EXPECT_NE(fault.find("accepted: "), std::string::npos) << fault;
    EXPECT_NE(fault.find(" or more"), std::string::npos) << fault;
    EXPECT_EQ(fault.find('\n'), std::string::npos);
  }
  EXPECT_NE(fault_of(load_scene("sine_euler"), "stationary", 0.1).find("knows no means"), std::string::npos);
  EXPECT_NE(fault_of(load_scene("vortex_pair"), "stationary", 0.1, "mu_1").find("not known"), std::string::npos);
  EXPECT_NE(fault_of(so4, "weak", 0.1, "mu_7").find("mu_7"), std::string::npos);
}

TEST(SelectOffTheSphere, ThreadsDoNotChangeAnError) {
  const auto s = bind_scene(load_scene("heavy_top"));
  const goal_question q{"weak", std::string(all_observables), s.scene.horizon, 1e-2};
  std::array<error_estimate, 2> found;
  for (int threads : {1, 2}) {
    const auto goal = make_goal({s, effort::standard, threads, 3}, q);
    const candidate who{"lie_heun", test::scheme_of(s, "lie_heun"), nullptr, 1};
    found[static_cast<std::size_t>(threads - 1)] = goal->error(who, s.scene.horizon / 8, 9);
  }
  EXPECT_GT(found[0].value, 0);
  EXPECT_EQ(found[0].value, found[1].value);
  EXPECT_EQ(found[0].uncertainty, found[1].uncertainty);
}

/// lo + the integral of 1 - F from there on: the mean, by Simpson's rule.
double mean_by(const known_marginal& law, double lo, double hi) {
  constexpr int n = 20'000;
  const double h = (hi - lo) / n;
  double sum = 0;
  for (int i = 0; i <= n; ++i) sum += (i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2) * (1 - law.cdf(lo + i * h));
  return lo + sum * h / 3;
}

TEST(KnownMarginals, HaveTheMeansOfTheGibbsLaw) {
  auto pair = load_scene("spin_pair");  // MODEL.md: <E> = kT - coth(1/kT) at kT = 0.1
  pair.vectors("quadratic") = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  pair.vector("field") = {0, 0, 0};
  pair.number("theta") = 0.8;
  const auto spins = bind_scene(pair);
  ASSERT_EQ(spins.offers->gibbs_marginals.size(), 1u);
  const auto& bond = spins.offers->gibbs_marginals[0];
  EXPECT_NEAR(mean_by(bond, -1, 1), -0.9000000041, 1e-9);
  EXPECT_NEAR(bond.value(pair.momentum), spins.model->energy(pair.momentum), 1e-15);

  const auto vortices = bind_scene(load_scene("vortex_pair"));
  const auto& h = vortices.offers->gibbs_marginals.at(0);
  const double least = -std::log(2.0) / M_PI;  // Gamma_1 Gamma_2 = 4
  EXPECT_NEAR(mean_by(h, least, least + 20), *vortices.offers->gibbs_mean("energy")->value, 1e-8);
  EXPECT_NEAR(h.value(vortices.scene.momentum), vortices.model->energy(vortices.scene.momentum), 1e-14);
  EXPECT_TRUE(bind_scene(load_scene("spin_pair")).offers->gibbs_marginals.empty());
}

// A dissipation three times as strong makes x_1 colder.
TEST(KnownMarginals, TellOneTemperatureFromAnother) {
  const auto healthy = restricted(bind_scene(load_scene("maxwell_bloch")), {"lie_heun"});
  auto cold = healthy;
  cold.schemes = healthy.with(with_dissipation(healthy.scene, 3 * dissipation_of(healthy.scene))).schemes;
  const auto verdict_on = [](const subject& s) {
    return test::verdict_of(test::quick_results(s, {"gibbs"}), "law of x1").kind;
  };
  EXPECT_EQ(verdict_on(healthy), verdict_kind::holds);
  EXPECT_EQ(verdict_on(cold), verdict_kind::refuted);
}

}  // namespace
}  // namespace polhode
