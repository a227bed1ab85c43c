// SPDX-License-Identifier: Apache-2.0
#include "ensemble/observing/observation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include <polhode/noise/normal.hpp>

#include "ensemble/observing/angle.hpp"
#include "ensemble/observing/direction_bins.hpp"
#include "ensemble/observing/sphere_bins.hpp"
#include "platform/isa.hpp"
#include "run/verify.hpp"

namespace polhode {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
constexpr auto at(int component, int lane) { return static_cast<std::size_t>(component * block_lanes + lane); }

/// Three normals for every lane of a block.
std::vector<double> random_block(std::uint64_t block) {
  std::vector<double> states(3 * block_lanes);
  for (int lane = 0; lane < block_lanes; ++lane) {
    const auto x =
        normals<3>({9, noise_kind::initial_state, block * block_lanes + static_cast<std::uint64_t>(lane), 0});
    for (int k = 0; k < 3; ++k) states[at(k, lane)] = x[k];
  }
  return states;
}

/// Four roundings: half a unit of the last place of pi, of pi/2 and of pi/4, and the quotient's with its polynomial.
constexpr double angle_bound = 6e-16;

double angle_error(double y, double x) {
  return static_cast<double>(std::fabs(static_cast<long double>(angle_of(y, x)) -
                                       std::atan2(static_cast<long double>(y), static_cast<long double>(x))));
}

TEST(Angle, IsThatOfTheStandardLibrary) {
  double worst = 0;
  for (int i = -200'000; i <= 200'000; ++i) {
    const double angle = i * (3.141592 / 200'000);
    worst = std::max(worst, angle_error(std::sin(angle) * (8 + i % 7), std::cos(angle) * (8 + i % 7)));
  }
  EXPECT_LT(worst, angle_bound);
  for (const double y : {-1.0, -1e-300, 1e-300, 1.0, 1e300})
    for (const double x : {-1e300, -1.0, -1e-300, 0.0, 1e-300, 1.0})
      EXPECT_LT(angle_error(y, x), angle_bound) << y << ' ' << x;
  for (const double zero : {0.0, -0.0}) {
    EXPECT_EQ(angle_of(zero, -1.0), std::numbers::pi);
    EXPECT_EQ(angle_of(zero, 1.0), 0);
    EXPECT_EQ(angle_of(zero, zero), 0);
  }
}

/// In one file that is compiled for every processor, one body at a time.
double expected_bin(const std::vector<double>& states, int lane, bool hemisphere) {
  const double a = states[at(0, lane)], b = states[at(1, lane)], c = states[at(2, lane)];
  const double largest = std::max({std::abs(a), std::abs(b), std::abs(c)});
  if (!std::isfinite(a) || !std::isfinite(b) || !std::isfinite(c) || largest == 0) return -1;
  const double x = a / largest, y = b / largest, z = c / largest, r = std::sqrt(x * x + y * y + z * z);
  return hemisphere ? hemisphere_bins::of(x / r, y / r, z / r) : longitude_bins::of(x, y, z / r);
}

TEST(DirectionBins, AreTheSameOnEveryInstructionSet) {
  const isa before = active_isa();
  for (const isa set : usable_isas()) {
    choose_isa(set);
    for (std::uint64_t block = 0; block < 2000; ++block) {
      auto states = random_block(block);
      const double odd[][3] = {{0, 0, 0},          {0, 0, 1},      {0, 0, -1},       {-1, 0, 0},
                               {-1, -0.0, 0},      {nan, 1, 1},    {1, infinite, 1}, {1, 1, nan},
                               {1e300, -1e300, 1}, {1e-310, 0, 0}, {1, 1, 0},        {-infinite, 0, 0}};
      if (block == 0)
        for (int lane = 0; lane < 12; ++lane)
          for (int k = 0; k < 3; ++k) states[at(k, lane)] = odd[lane][k];
      direction_bins found;
      find_bins(states.data(), found);
      for (int lane = 0; lane < block_lanes; ++lane) {
        const auto i = static_cast<std::size_t>(lane);
        ASSERT_EQ(found.longitude[i], expected_bin(states, lane, false)) << name_of(set) << ' ' << block << ' ' << lane;
        ASSERT_EQ(found.hemisphere[i], expected_bin(states, lane, true)) << name_of(set) << ' ' << block << ' ' << lane;
      }
    }
  }
  choose_isa(before);
}

TEST(RunningMoments, MergeAsOneSample) {
  std::vector<double> values(101);
  long double mean = 0, squares = 0;
  for (std::size_t i = 0; i < values.size(); ++i) mean += values[i] = 1e6 + std::sin(static_cast<double>(i));
  mean /= 101;
  for (const double x : values) squares += (x - mean) * (x - mean);
  const auto all = std::span(values);
  for (const std::size_t cut : {0u, 1u, 30u, 100u, 101u}) {
    auto joined = running_moments::of(all.first(cut));
    joined.merge(running_moments::of(all.subspan(cut)));
    EXPECT_EQ(joined.count, 101);
    EXPECT_NEAR(joined.mean, static_cast<double>(mean), 1e-9);
    EXPECT_NEAR(joined.deviation(), std::sqrt(static_cast<double>(squares) / 100), 1e-9);
  }
}

TEST(Observation, LeavesOutTheLostAndTheLanesBeyond) {
  const auto s = bind_scene(load_scene("paper"));
  const std::vector<double> momentum{0.6, 0.48, 0.64};
  auto states = random_block(0);
  states[at(0, 3)] = nan;
  states[at(2, 5)] = -infinite;
  constexpr int lanes = block_lanes - 2;
  ensemble_observer observer(*s.model, momentum);
  auto seen = ensemble_observer::nothing(*s.model);
  observer.observe(states, lanes, seen);
  EXPECT_EQ(seen.lost, 2);
  EXPECT_EQ(seen.energy.count, lanes - 2);
  double energy = 0, second = 0, change = 0;
  for (int lane = 0; lane < lanes; ++lane) {
    if (lane == 3 || lane == 5) continue;
    const double x = states[at(0, lane)], y = states[at(1, lane)], z = states[at(2, lane)];
    energy += 0.5 * (x * x + y * y / 2 + z * z / 3) / (lanes - 2);
    second += y / (lanes - 2);
    change = std::max(change, std::abs(std::sqrt(x * x + y * y + z * z) - 1));  // the Casimir is the length, 1 at first
  }
  EXPECT_NEAR(seen.energy.mean, energy, 1e-14);
  EXPECT_NEAR(seen.components[1].mean, second, 1e-14);
  EXPECT_NEAR(seen.casimir_change, change, 1e-13);
}

}  // namespace
}  // namespace polhode
