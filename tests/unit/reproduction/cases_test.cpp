// SPDX-License-Identifier: Apache-2.0
// The cases at reduced size against numbers that are known otherwise.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <set>

#include "reports/model/errors.hpp"
#include "reproduction/magpy_runs.hpp"
#include "reproduction/reproduce.hpp"

namespace polhode::test {
namespace {

using report::agreement;

const report::reproduced_number& number_of(const report::reproduction& r, std::string_view beginning) {
  for (const auto& n : r.numbers)
    if (n.quantity.starts_with(beginning)) return n;
  throw std::out_of_range("no number " + std::string(beginning));
}

report::reproduction quick(const char* name) {
  return reproduce(chosen_reproductions({name}), {effort::quick, 2, 1}).front();
}

void expect_verdicts(const report::reproduction& r, const std::set<std::string>& explained) {
  for (const auto& n : r.numbers) {
    const bool expected = std::ranges::any_of(explained, [&](const auto& e) { return n.quantity.starts_with(e); });
    EXPECT_EQ(n.verdict, expected ? agreement::explained : agreement::agrees) << r.name << ": " << n.quantity;
    EXPECT_FALSE(n.why.empty()) << n.quantity;
  }
  EXPECT_FALSE(r.source.empty());
}

TEST(Reproduce, NamesAreTakenOnceAndUnknownOnesRefused) {
  EXPECT_EQ(chosen_reproductions({}).size(), reproduction_cases().size());
  EXPECT_EQ(chosen_reproductions({"paper", "two_spins", "paper"}), (std::vector<std::size_t>{5, 1}));
  EXPECT_THROW(chosen_reproductions({"two_spin"}), input_error);
  EXPECT_THROW(chosen_reproductions({""}), input_error);
}

TEST(Reproduce, UniaxialSpin) {
  const auto r = quick("uniaxial_spin");
  expect_verdicts(r, {});
  // By parts, E[m^2] = 1 / I - 1 / (2 chi), I = int_0^1 2 chi exp(chi (m^2 - 1)) dm: Simpson's rule.
  const double chi = 7.2e5 * 2.8e-26 / (1.3806505e-23 * 300);
  constexpr int n = 2000;
  double sum = 0;
  for (int i = 0; i <= n; ++i) {
    const double m = static_cast<double>(i) / n, weight = i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2;
    sum += weight / (3 * n) * 2 * chi * std::exp(chi * (m * m - 1));
  }
  EXPECT_NEAR(*number_of(r, "E[m_z^2], exact").ours, 1 / sum - 1 / (2 * chi), 1e-10);
}

TEST(Reproduce, TwoSpins) {
  const auto r = quick("two_spins");
  expect_verdicts(r, {});
  EXPECT_NEAR(*number_of(r, "mean energy, exact").ours, -0.9000000041, 1e-10);
}

TEST(Reproduce, SchemesOnTheSphere) {
  const auto r = quick("sds_on_s2");
  expect_verdicts(r, {"figures 3, 4"});
}

TEST(Reproduce, LiePoissonMidpoint) { expect_verdicts(quick("lie_poisson_midpoint"), {}); }

TEST(Reproduce, ThePaper) {
  const auto r = quick("paper");
  expect_verdicts(r, {"dh/dt"});
  EXPECT_NEAR(*number_of(r, "stationary E[h]").published, 0.27662786228, 1e-11);
  EXPECT_NEAR(*number_of(r, "first Lyapunov exponent").ours, 0.020196, 1e-6);
  EXPECT_NEAR(*number_of(r, "sum of both").ours, -0.0867830798, 1e-9);
  EXPECT_NEAR(*number_of(r, "first exponent at theta = 1").ours, -0.04358, 1e-5);
}

TEST(Reproduce, MagpysRunsHaveTheSlopeThatItPrints) {
  const auto r = quick("magpy_convergence");
  expect_verdicts(r, {"Heun, 1024 runs"});
  EXPECT_NEAR(*number_of(r, "Heun, their runs: slope").ours, 0.509, 0.0005);
}

// Without noise and damping: a turn about the field, by 2 atan(h dt / 2) a step of the midpoint rule.
TEST(MagpyRuns, TurnsAsTheMidpointRuleDoes) {
  magpy_task task;
  task.alpha = task.strength = 0;
  task.field = 0.5;
  task.levels = 3;
  const auto found = magpy_differences(task, magpy_method::midpoint, 5, 1);
  const auto dt = task.dt();
  const auto angle = [&](double h) { return task.horizon / h * 2 * std::atan(task.field * h / 2); };
  for (std::size_t l = 0; l < 2; ++l)
    EXPECT_NEAR(found[l], 2 * std::fabs(std::sin((angle(dt[l]) - angle(dt[l + 1])) / 2)), 1e-11);
}

/// Sum over the steps of the cut increments of channels 2 and 3, from the standard normals of a seed.
std::array<double, 2> sum_of_cut(std::uint64_t seed, int steps, int fine, double dt) {
  std::mt19937_64 bits(seed);
  std::normal_distribution<double> normal;
  const double most = std::sqrt(-2 * std::log(dt));
  std::array<double, 2> sum{};
  for (int i = 0; i < steps; ++i) {
    std::array<double, 3> z{};
    for (int k = 0; k < 3 * fine; ++k) z[static_cast<std::size_t>(k % 3)] += normal(bits) / std::sqrt(double(fine));
    for (std::size_t k = 0; k < 2; ++k) sum[k] += std::sqrt(dt) * std::max(-most, std::min(most, z[k + 1]));
  }
  return sum;
}

// Next to no noise and nothing else: m = e_1 moves by strength times the increments across it.
TEST(MagpyRuns, CutsIncrementsByTheirStep) {
  magpy_task task;
  task.field = task.alpha = 0;
  task.strength = 1e-7;
  task.levels = 2;
  double expected = 0;
  for (const std::uint64_t seed : {0, 13, 52, 117, 208}) {
    const auto coarse = sum_of_cut(seed, 100, 2, 0.64), fine = sum_of_cut(seed, 200, 1, 0.32);
    expected += std::hypot(coarse[0] - fine[0], coarse[1] - fine[1]) / 5;
  }
  EXPECT_GT(expected, 0.5);
  EXPECT_NEAR(magpy_differences(task, magpy_method::midpoint_cut, 5, 1)[0], task.strength * expected,
              1e-5 * task.strength * expected);
  EXPECT_LT(magpy_differences(task, magpy_method::midpoint, 5, 1)[0], 1e-5 * task.strength);
}

// Of ten runs the seeds are 0 twice and eight others.
TEST(MagpyRuns, CountsItsSeeds) {
  EXPECT_NEAR(effective_magpy_runs(5), 5, 1e-12);
  EXPECT_NEAR(effective_magpy_runs(10), 1 / (0.2 * 0.2 + 8 * 0.1 * 0.1), 1e-12);
  EXPECT_NEAR(effective_magpy_runs(5000), 24.871513759916272, 1e-9);  // counted elsewhere
}

}  // namespace
}  // namespace polhode::test
