// SPDX-License-Identifier: Apache-2.0
// What the audit of noise says of few lanes, channels, paths and numbers, each by its definition.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "statistics/noise/noise_audit.hpp"
#include "unit/statistics/audit_numbers.hpp"

namespace polhode::test {
namespace {

double stated(const noise_audit& audit, const std::string& what) {
  for (const auto& d : audit.deviations())
    if (d.what == what) return d.z;
  ADD_FAILURE() << "no " << what;
  return NAN;
}

// One number of every lane in 64 steps, of one channel after the other; each pair's sum over the root of the sum of the
// latter's squares, whatever the size of the numbers.
TEST(NoiseAudit, LanesAreComparedByOneNumberIn64StepsOfOneChannelAfterTheOther) {
  constexpr int rows = 64 * 6 + 10;
  const auto z = drawn(rows, 7);
  const auto dw = scaled(z, 2 * std::sqrt(dt));
  for (const std::size_t heard : {2, 3}) {
    noise_audit audit(static_cast<int>(heard), 0);
    std::size_t from = 0;
    for (const int steps : {50, 100, 64, rows - 214}) {
      const auto size = static_cast<std::size_t>(steps * channels * lanes);
      audit.add({steps, channels, 0, std::span(dw).subspan(from, size), {}, {}, dt});
      from += size;
    }
    double largest = 0;
    for (std::size_t a = 0; a < lanes; ++a)
      for (std::size_t b = 0; b < a; ++b) {
        double product = 0, square = 0;
        for (std::size_t i = 0; i < 7; ++i) {
          const auto& x = z[64 * i][i % heard];
          product += 4 * x[a] * x[b];
          square += 4 * x[b] * x[b];
        }
        largest = std::max(largest, std::fabs(product) / std::sqrt(square));
      }
    const auto pairs = lanes * (lanes - 1) / 2;
    const double share = pairs * std::erfc(largest / std::sqrt(2.0));
    ASSERT_LT(share, 1e-3);
    EXPECT_NEAR(stated(audit, "product of two lanes"), quantile(complement(boost::math::normal(), share / 2)), 1e-9);
  }
}

// 11136 numbers looked at closely, of which 0.705 are expected beyond 4: none is a little few, and one, as P(>= 1) is
// more than a half, nothing at all.
TEST(NoiseAudit, ATailIsWhatIsBeyondFourAndNotFourItself) {
  constexpr int pieces = 87;
  noise_audit none(1, 0), one(1, 0);
  std::vector<float> z(2 * lanes, 1);
  z[3] = 4, z[70] = -4;
  for (int i = 0; i < pieces; ++i) none.add({2, 1, 0, {}, z, {}, dt});
  for (int i = 0; i < pieces; ++i) {
    z[3] = i == 40 ? std::nextafter(4.0f, 5.0f) : 4;
    one.add({2, 1, 0, {}, z, {}, dt});
  }
  const double expected = pieces * 2 * lanes * std::erfc(4 / std::sqrt(2.0));
  EXPECT_NEAR(stated(none, "tail beyond 4 of channel 1"), quantile(boost::math::normal(), std::exp(-expected)), 1e-12);
  EXPECT_EQ(stated(one, "tail beyond 4 of channel 1"), 0);
}

TEST(NoiseAudit, OneChannelIsHeardAsManyAre) {
  const auto z = drawn(2, 8);
  std::vector<double> dw;
  double sum = 0, next = 0;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t l = 0; l < lanes; ++l) {
      dw.push_back(std::sqrt(dt) * z[i][0][l]);
      sum += z[i][0][l];
      if (i == 0 && l > 0) next += z[0][0][l - 1] * z[0][0][l];
    }
  noise_audit block(1, 0), path(1, 0);
  block.add({2, 1, 0, dw, {}, {}, dt});
  path.add_path({2 * lanes, 1, 0, dw, {}, {}, dt}, 5);
  for (const auto* audit : {&block, &path}) {
    EXPECT_EQ(audit->increments(), 2 * lanes);
    EXPECT_NEAR(stated(*audit, "mean of channel 1"), sum / std::sqrt(2 * lanes), 1e-12);
  }
  EXPECT_NEAR(stated(block, "first steps, lane times next lane"), next / std::sqrt(lanes - 1), 1e-12);
}

// The first steps of 64 paths are those of the lanes of a block.
TEST(NoiseAudit, FirstStepsOfPathsAreThoseOfTheirLanes) {
  const auto z = drawn(1, 9);
  noise_audit audit(channels, 0);
  double next = 0, far = 0;
  for (std::size_t l = 0; l < lanes; ++l) {
    std::vector<double> dw(65 * channels, 0.1);
    for (std::size_t k = 0; k < channels; ++k) {
      dw[k] = std::sqrt(dt) * z[0][k][l];
      if (l >= 1) next += z[0][k][l - 1] * z[0][k][l];
      if (l >= 32) far += z[0][k][l - 32] * z[0][k][l];
    }
    audit.add_path({65, channels, 0, dw, {}, {}, dt}, static_cast<int>(l));
  }
  EXPECT_NEAR(stated(audit, "first steps, lane times next lane"), next / std::sqrt(63 * channels), 1e-12);
  EXPECT_NEAR(stated(audit, "first steps, lane times lane + 32"), far / std::sqrt(32 * channels), 1e-12);
}

TEST(NoiseAudit, TwoChannelsHaveOneArea) {
  const std::vector<double> dw(8 * 2 * lanes, 0.1), area(8 * lanes, 0.25 * dt / 2);
  noise_audit audit(2, 1);
  audit.add({8, 2, 1, dw, {}, area, dt});
  EXPECT_NEAR(stated(audit, "mean of area 12"), 0.25 * std::sqrt(8 * lanes), 1e-12);
}

// Of four channels two areas share one or none; 16384 numbers, two rows again and again.
TEST(NoiseAudit, AreasOfFourChannelsShareOneOrNone) {
  constexpr int four = 4, six = 6, pieces = 128, cells = 5;
  const std::vector<std::pair<int, int>> pair{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
  const auto z = drawn(2 * 4, 10);  // 24 rows of lanes
  std::vector<double> dw = scaled(z, std::sqrt(dt)), area = scaled(z, dt / 2);
  dw.resize(2 * four * lanes), area.resize(2 * six * lanes);
  noise_audit audit(four, six, cells);
  for (int i = 0; i < pieces; ++i) audit.add({2, four, six, dw, {}, area, dt});
  const auto law = of_cells(cells);
  for (std::size_t p = 0; p < six; ++p)
    for (std::size_t q = p + 1; q < six; ++q) {
      double sum = 0;
      for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t l = 0; l < lanes; ++l)
          sum += area[(i * six + p) * lanes + l] * area[(i * six + q) * lanes + l] / (dt * dt / 4);
      const auto [i, j] = pair[p];
      const auto [a, b] = pair[q];
      const bool disjoint = p + q == 5;  // 12 34, 13 24, 14 23
      const double variance = disjoint ? law.square * law.square : law.shared_channel;
      EXPECT_NEAR(stated(audit, fmt::format("area {}{} times area {}{}", i + 1, j + 1, a + 1, b + 1)),
                  pieces * sum / std::sqrt(pieces * 2 * lanes * variance), 1e-9);
    }
}

// A block is known by its first steps alone, whatever comes again later.
TEST(NoiseAudit, WhatComesAgainInABlockIsNoPathThatStartsAlike) {
  const auto dw = scaled(drawn(8, 12), std::sqrt(dt));
  noise_audit audit(channels, 0);
  for (int piece = 0; piece < 3; ++piece) audit.add({8, channels, 0, dw, {}, {}, dt});
  EXPECT_EQ(stated(audit, "number of paths that start alike"), 0);
}

TEST(NoiseAudit, APathWithoutNoiseIsNotHeard) {
  noise_audit audit(channels, 0);
  audit.add_path({5, channels, 0, {}, {}, {}, dt}, 0);
  EXPECT_EQ(audit.increments(), 0);
}

}  // namespace
}  // namespace polhode::test
