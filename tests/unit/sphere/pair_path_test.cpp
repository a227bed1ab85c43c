// SPDX-License-Identifier: Apache-2.0
// A pair without noise is a path: closed forms, and how far one is followed.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "unit/sphere/pairs.hpp"

namespace polhode::test {
namespace {

TEST(PairPath, TurnsAboutTheSum) {
  const double exchange = 0.8, time = 20;
  const Eigen::Vector3d sum = first + second;
  const Eigen::Vector3d turned = Eigen::AngleAxisd(-exchange * sum.norm() * time, sum.normalized()) * first;
  holds(expected(bound(exchange, 0, 0, false), both(first, second), time, "mu_2", 1e-9), turned[1], 1e-11);
}

// u = S_1.S_2 of two unit spins without noise: u' = -2 theta J (1 - u^2).
TEST(PairPath, FollowsTheDissipation) {
  const double exchange = 0.8, damping = 0.5, time = 1.5, u = first.dot(second);
  const double after = std::tanh(std::atanh(u) - 2 * damping * exchange * time);
  holds(expected(bound(exchange, damping, 0, false), both(first, second), time, "energy", 1e-9), exchange * after,
        1e-12);
}

// Both at rest on the axis of their exchange and field: two ways of following agree, and rounding is left.
TEST(PairPath, IsNeverMoreCertainThanRounding) {
  for (const double radius : {1.0, 100.0}) {
    const sphere_problem site{none, 0.2, radius, none, {0, 0, 0.5}};
    pair_expectations at_rest({{site, site}, 0.3}, radius * both({0, 0, 1}, {0, 0, 1}), 2, 8);
    const auto found = at_rest.of({.site = 0, .axis = 2, .power = 1}, 1e-9);
    EXPECT_EQ(found.value, radius);
    EXPECT_EQ(found.uncertainty, 1e-14 * radius);
  }
}

// Both turn at |A| |Pi| + |b| + |J| |mu|, times 1 + theta |Pi|.
TEST(PairPath, RefusesMoreTurnsThanCanBeFollowed) {
  const sphere_problem site{Eigen::Vector3d(0, 0, 2).asDiagonal(), 0.5, 3, none, {0, 0, 0.5}};
  const double turning = 2 * (2 * 3 + 0.5 + 0.3 * std::sqrt(18.0)) * (1 + 0.5 * 3);
  pair_expectations long_({{site, site}, 0.3}, 3 * both(first, second), 1.01e7 / turning, 8);
  const auto found = long_.of({.site = 0, .axis = 2, .power = 1}, 1e-9);
  EXPECT_FALSE(found.value);
  EXPECT_EQ(found.reason, "no noise, and too many turns to follow");
}

// At rest a path is followed at once, so that the limit is seen from below as well: both rates, times 1 + theta |Pi|.
TEST(PairPath, CountsTheTurnsOfBoth) {
  const sphere_problem site{Eigen::Vector3d(0, 0, 0.4).asDiagonal(), 0.3, 1.5, none, {0, 0, 0.5}};
  auto other = site;
  other.radius = 0.8;
  const sphere_pair pair{{site, other}, -0.7};
  const momenta start = both({0, 0, 1.5}, {0, 0, 0.8});
  const double felt = 0.5 + 0.7 * start.norm();
  const double turning = (0.4 * 1.5 + felt) * (1 + 0.3 * 1.5) + (0.4 * 0.8 + felt) * (1 + 0.3 * 0.8);
  const auto within = [&](double turns) {
    return pair_expectations(pair, start, turns / turning, 8).of({.site = 0, .axis = 2, .power = 1}, 1e-9).value;
  };
  EXPECT_EQ(within(0.99e7), 1.5);
  EXPECT_FALSE(within(1.01e7));
}

// Turns of 0.75 + 0.25 * 5 for each, of which the limit is a whole number.
TEST(PairPath, FollowsAsManyTurnsAsItMay) {
  sphere_problem site{none, 0, 3, none, {0, 0, 0.75}}, other = site;
  other.radius = 4;
  const auto after = [&](double time) {
    return pair_expectations({{site, other}, 0.25}, both({0, 0, 3}, {0, 0, 4}), time, 8)
        .of({.site = 1, .axis = 2, .power = 1}, 1e-9)
        .value;
  };
  EXPECT_EQ(after(2.5e6), 4);
  EXPECT_FALSE(after(2.5e6 + 1));
}

}  // namespace
}  // namespace polhode::test
