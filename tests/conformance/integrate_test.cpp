// SPDX-License-Identifier: Apache-2.0
// The loops of the installed headers are steps one after another, also where they merge two flows into one.
#include <polhode/integrate.hpp>

#include <gtest/gtest.h>
#include <polhode/schemes/heun.hpp>
#include <polhode/schemes/magnus.hpp>
#include <polhode/schemes/strang.hpp>
#include <polhode/schemes/strang_weak2.hpp>
#include <polhode/systems/rigid_body.hpp>

#include <vector>

namespace polhode {
namespace {

using state = vec<double, 3>;

const rigid_body body({1, 2, 3}, 0.5, rigid_body::isotropic(0.5));
constexpr double dt = 0.02;

std::vector<state> starts() { return {{{0.6, 0.48, 0.64}}, {{0, 0.8, -0.6}}, {{1, 0, 0}}}; }

wiener<double, 3> increment(std::uint64_t step, std::size_t path) {
  return wiener_at<3>({.seed = 5, .path = path, .step = step}, dt);
}
wiener_levy<double, 3> with_areas(std::uint64_t step, std::size_t path) {
  wiener_levy<double, 3> w;
  w.dt = dt;
  w.dw = increment(step, path).dw;
  w.area = {{0.01 * static_cast<double>(path), 0.001, -0.002}};
  return w;
}

double apart(const state& a, const state& b) {
  const auto d = a - b;
  return std::sqrt(dot(d, d));
}

template <class Scheme, class Increment>
void expect_steps_in_a_row(std::uint64_t steps, const Increment& of) {
  auto paths = starts();
  advance<Scheme>(body, std::span(paths), dt, steps, of);
  const auto stepped = prepared<Scheme>(body, dt);
  for (std::size_t p = 0; p < paths.size(); ++p) {
    auto mu = starts()[p];
    for (std::uint64_t i = 0; i < steps; ++i) mu = Scheme::step(stepped, mu, of(i, p));
    EXPECT_LT(apart(paths[p], mu), 1e-13) << Scheme::info.name << ", " << steps << " steps, path " << p;
  }
}

TEST(Advance, IsStepAfterStep) {
  static_assert(merges_on<strang, rigid_body> && merges_on<strang_weak2, rigid_body> && !merges_on<heun, rigid_body>);
  for (const std::uint64_t steps : {1, 2, 50}) {
    expect_steps_in_a_row<heun>(steps, increment);
    expect_steps_in_a_row<strang>(steps, increment);
    expect_steps_in_a_row<strang_weak2>(steps, increment);
    expect_steps_in_a_row<magnus>(steps, with_areas);
  }
}

TEST(Advance, WithoutStepsNothingMoves) {
  auto paths = starts();
  advance<strang>(body, std::span(paths), dt, 0, increment);
  for (std::size_t p = 0; p < paths.size(); ++p) EXPECT_EQ(paths[p].c, starts()[p].c);
}

TEST(Integrate, IsOnePathWithNoiseByItsAddress) {
  auto path = std::vector{starts()[0]};
  advance<strang>(body, std::span(path), dt, 20, [](std::uint64_t i, std::size_t) { return increment(7 + i, 3); });
  const auto mu = integrate<strang>(body, starts()[0], dt, 20, {.seed = 5, .path = 3, .step = 7});
  EXPECT_LT(apart(mu, path[0]), 1e-14);
}

}  // namespace
}  // namespace polhode
