// SPDX-License-Identifier: Apache-2.0
// The loops of the installed headers are steps one after another, also where they merge two flows into one.
#include <polhode/integrate.hpp>

#include <gtest/gtest.h>
#include <polhode/schemes/heun.hpp>
#include <polhode/schemes/magnus.hpp>
#include <polhode/schemes/strang.hpp>
#include <polhode/schemes/strang_weak2.hpp>
#include <polhode/systems/rigid_body.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace polhode {
namespace {

using vec3 = vec<double, 3>;

const rigid_body body({1, 2, 3}, 0.5, rigid_body::isotropic(0.5));
constexpr double dt = 0.02;

std::vector<vec3> starts() { return {{{0.6, 0.48, 0.64}}, {{0, 0.8, -0.6}}, {{1, 0, 0}}}; }

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

double largest_difference(const vec3& a, const vec3& b) {
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
    EXPECT_LT(largest_difference(paths[p], mu), 1e-13) << Scheme::info.name << ", " << steps << " steps, path " << p;
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
  EXPECT_LT(largest_difference(mu, path[0]), 1e-14);
}

// The drift of a Wiener process by its time, as a scheme sees it.
struct clock_reader {
  static constexpr auto info = heun::info;
  template <class System, class S>
  static auto step(const System&, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    auto out = mu;
    out[0] = out[0] + w.t * w.dt;
    return out;
  }
};

TEST(Integrate, HandsEachStepTheTimeAtWhichItBegins) {
  const auto mu = integrate<clock_reader>(body, starts()[0], 0.5, 4, {.seed = 5, .path = 3, .step = 2});
  EXPECT_DOUBLE_EQ(mu[0] - starts()[0][0], 0.5 * (1.0 + 1.5 + 2.0 + 2.5));
}

struct weather {
  double rain = 0;
};
TEST(Increment, WithVariablesIsTakenWhereTheyAreNotAskedFor) {
  with_variables<wiener<double, 3>, weather> w;
  static_cast<wiener<double, 3>&>(w) = increment(0, 0);
  w.rain = 2;
  EXPECT_EQ(heun::step(body, starts()[0], w).c, heun::step(body, starts()[0], increment(0, 0)).c);
  EXPECT_EQ(w.rain, 2);
}

// A right angle encloses half a square; however a path is cut, it encloses the same.
TEST(Chen, JoinsStepsOneAfterAnother) {
  const auto along = [](int axis) {
    wiener_levy<double, 3> w;
    w.dt = 0.25;
    w.dw[axis] = 2;
    return w;
  };
  const auto corner = chen(along(0), along(1)), back = chen(along(1), along(0)), other = chen(along(1), along(2));
  EXPECT_EQ(corner.dt, 0.5);
  EXPECT_EQ(corner.dw.c, (std::array<double, 3>{2, 2, 0}));
  EXPECT_EQ(corner.area.c, (std::array<double, 3>{2, 0, 0}));  // of the pairs 12, 13, 23
  EXPECT_EQ(back.area.c, (std::array<double, 3>{-2, 0, 0}));
  EXPECT_EQ(other.area.c, (std::array<double, 3>{0, 0, 2}));
  const auto a = with_areas(1, 1), b = with_areas(2, 2), c = with_areas(3, 0);
  const auto left = chen(chen(a, b), c), right = chen(a, chen(b, c));
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(left.dw[k], a.dw[k] + b.dw[k] + c.dw[k], 1e-16);
    EXPECT_NEAR(left.area[k], right.area[k], 1e-16);
  }
  const double between = a.dw[0] * b.dw[2] - a.dw[2] * b.dw[0];
  EXPECT_NEAR(chen(a, b).area[1], a.area[1] + b.area[1] + between / 2, 1e-17);
}

// The numbers of an address, of which those that are not active stay zero.
TEST(WienerAt, IsTheNormalsOfItsAddress) {
  const noise_address address{.seed = 5, .path = 7, .step = 11};
  const auto z = normals<5>({.seed = 5, .kind = noise_kind::increment, .path = 7, .step = 11});
  for (const int active : {0, 1, 2, 4, 5}) {
    const auto w = wiener_at<5>(address, 0.04, active);
    EXPECT_EQ(w.dt, 0.04);
    for (int k = 0; k < 5; ++k) EXPECT_DOUBLE_EQ(w.dw[k], k < active ? 0.2 * z[k] : 0) << active << ' ' << k;
  }
}

}  // namespace
}  // namespace polhode
