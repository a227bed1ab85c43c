// SPDX-License-Identifier: Apache-2.0
// Dimensions of sets that are known: a great circle, the sphere, and measures whose dimensions differ.
#include "statistics/box_dimension.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "ensemble/observing/sphere_bins.hpp"

namespace polhode {
namespace {

constexpr double pi = std::numbers::pi;
using point = std::array<double, 3>;
using sampler = std::function<point(std::mt19937_64&)>;

double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

point at(double longitude, double z) {
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(longitude), r * std::sin(longitude), z};
}

/// Four clouds, boxes as the experiment takes them.
std::vector<std::vector<box_level>> clouds_of(const sampler& sample) {
  std::vector<std::vector<box_level>> clouds;
  for (unsigned cloud = 0; cloud < 4; ++cloud) {
    std::mt19937_64 random(cloud + 1);
    std::vector<std::uint32_t> counts(hemisphere_bins::count);
    for (int i = 0; i < 1 << 17; ++i) {
      const auto p = sample(random);
      ++counts[static_cast<std::size_t>(hemisphere_bins::of(p[0], p[1], p[2]))];
    }
    clouds.push_back(count_boxes(counts, 2, hemisphere_bins::side, 16));
  }
  return clouds;
}

std::array<double, 3> dimensions(const sampler& sample) {
  const auto clouds = clouds_of(sample);
  const auto usable = usable_levels(clouds, hemisphere_bins::side);
  std::array<double, 3> out{};
  for (const auto kind : box_kinds) {
    const auto found = fit_dimension(clouds, kind, usable);
    EXPECT_TRUE(found);
    if (found) out[static_cast<std::size_t>(kind)] = found->value.value;
  }
  return out;
}

/// Around an axis that is none of the grid's.
point turned(const point& p) {
  const double c = std::cos(0.7), s = std::sin(0.7), d = std::cos(1.1), e = std::sin(1.1);
  const point q{c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]};
  return {d * q[0] + e * q[2], q[1], -e * q[0] + d * q[2]};
}

/// z in [-0.6, 0.6] by the binary digits of a number, each 1 with probability p: D_1 - 1 is its entropy in bits, D_2 -
/// 1 = -log2(p^2 + q^2), D_0 = 2.
point binomial(std::mt19937_64& random, double p) {
  double z = 0;
  for (int digit = 1; digit <= 20; ++digit) z += (uniform(random) < p ? 1 : 0) * std::exp2(-digit);
  return at(2 * pi * uniform(random), 0.6 * (2 * z - 1));
}

TEST(BoxDimension, OfAGreatCircleIsOne) {
  const auto d = dimensions([](auto& random) { return turned(at(2 * pi * uniform(random), 0)); });
  for (const double x : d) EXPECT_NEAR(x, 1, 0.04);
}

TEST(BoxDimension, OfTheSphereIsTwo) {
  const auto d = dimensions([](auto& random) { return at(2 * pi * uniform(random), 2 * uniform(random) - 1); });
  for (const double x : d) EXPECT_NEAR(x, 2, 0.06);  // boxes on the rim of a chart are not whole
}

TEST(BoxDimension, OfAPointIsZero) {
  for (const double x : dimensions([](auto&) { return at(0.3, 0.2); })) EXPECT_NEAR(x, 0, 1e-9);
}

// Cantor's middle thirds across, an interval along: 1 + log 2 / log 3, whatever is counted.
TEST(BoxDimension, OfACantorSetOfCirclesIsThatOfTheCantorSetAndOne) {
  const auto d = dimensions([](auto& random) {
    double z = 0;
    for (int digit = 1; digit <= 12; ++digit) z += (uniform(random) < 0.5 ? 2 : 0) * std::pow(3.0, -digit);
    return turned(at(2 * pi * uniform(random), 0.8 * (2 * z - 1)));
  });
  for (const double x : d) EXPECT_NEAR(x, 1 + std::log(2) / std::log(3), 0.07);
}

TEST(BoxDimension, TellsInformationFromPairs) {
  const double p = 0.15, q = 1 - p;
  const double information = 1 - p * std::log2(p) - q * std::log2(q), pairs = 1 - std::log2(p * p + q * q);
  const auto d = dimensions([&](auto& random) { return turned(binomial(random, p)); });
  EXPECT_NEAR(d[1], information, 0.08);
  EXPECT_NEAR(d[2], pairs, 0.08);
  EXPECT_LT(d[2], d[1]);
  EXPECT_LT(d[1], d[0]);
}

TEST(BoxDimension, AFewPointsSayNothing) {
  std::vector<std::uint32_t> counts(hemisphere_bins::count);
  for (std::size_t i = 0; i < counts.size(); i += 1001) ++counts[i];
  const std::vector clouds(2, count_boxes(counts, 2, hemisphere_bins::side, 16));
  EXPECT_FALSE(fit_dimension(clouds, box_kind::information, usable_levels(clouds, hemisphere_bins::side)));
}

TEST(BoxDimension, CountsByHand) {
  const std::vector<std::uint32_t> counts{3, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
                                          0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 4};  // two charts of 4 x 4
  const auto levels = count_boxes(counts, 2, 4, 2);
  ASSERT_EQ(levels.size(), 2u);
  EXPECT_EQ(levels[0].side, 2);
  EXPECT_EQ(levels[1].boxes[0], 3);
  EXPECT_NEAR(levels[1].boxes[2], 8 * 7 / 18.0, 1e-12);  // 3.2 + 4.3 ordered pairs of 8.7
  const double entropy = std::log(8) - (3 * std::log(3) + 4 * std::log(4)) / 8;
  EXPECT_NEAR(levels[1].boxes[1], std::exp(entropy + 2 / 16.0), 1e-12);
  EXPECT_EQ(levels[0].boxes[0], 3);
}

// boxes = C side^d exactly, of two clouds: their mean slope, and the mean line at one box a side.
TEST(BoxDimension, IsTheSlopeOfTheLineAndItsValueAtOne) {
  std::vector<std::vector<box_level>> clouds;
  for (const auto& [prefactor, slope] : {std::pair{2.0, 1.4}, {8.0, 1.6}}) {
    auto& cloud = clouds.emplace_back();
    for (const int side : {16, 32, 64, 128}) {
      const double boxes = prefactor * std::pow(side, slope);
      cloud.push_back({side, 16, {boxes, 2 * boxes, 3 * boxes}});
    }
  }
  clouds[1][3].fill = 15.9;  // both together hold too few
  const auto usable = usable_levels(clouds, hemisphere_bins::side);
  EXPECT_EQ(usable, (std::vector{true, true, true, false}));
  const auto fit = fit_dimension(clouds, box_kind::information, usable);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->value.value, 1.5, 1e-13);
  EXPECT_NEAR(fit->boxes_at_one, 8, 1e-11);
}

// By the sums of a least-squares line in binary logarithms: sides 4, 16, 32 of those given, the second is not usable,
// and a fifth was taken back.
TEST(BoxDimension, EveryUsableLevelHasAPartInTheLineAndNoOther) {
  std::vector<std::vector<box_level>> clouds;
  for (const double c : {1.0, 1.5})
    clouds.push_back({{4, 20, {8 * c, 0, 0}},
                      {8, 20, {100, 0, 0}},
                      {16, 20, {32 * c * c, 0, 0}},
                      {32, 20, {256, 0, 0}},
                      {64, 20, {7000, 0, 0}}});
  std::vector<bool> usable{true, false, true, true, true};
  usable.pop_back();
  double slope = 0, intercept = 0;
  for (auto& cloud : clouds) {
    cloud.pop_back();
    double x = 0, y = 0, xx = 0, xy = 0;
    for (const std::size_t l : {0, 2, 3}) {
      const double a = std::log2(cloud[l].side), b = std::log2(cloud[l].boxes[0]);
      x += a / 3, y += b / 3, xx += a * a / 3, xy += a * b / 3;
    }
    slope += (xy - x * y) / (xx - x * x) / 2;
    intercept += (y - (xy - x * y) / (xx - x * x) * x) / 2;
  }
  const auto fit = fit_dimension(clouds, box_kind::occupied, usable);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->value.value, slope, 1e-12);
  EXPECT_NEAR(fit->boxes_at_one, std::exp2(intercept), 1e-11);
}

TEST(BoxDimension, NoLevelFinerThanFixedIsUsable) {
  const std::vector<std::vector<box_level>> clouds(2, {{16, 90, {4, 4, 4}}, {32, 90, {4, 4, 4}}, {64, 90, {4, 4, 4}}});
  EXPECT_EQ(usable_levels(clouds, 32), (std::vector{true, true, false}));
}

// points = 16 x 7 side^dimension fill that side, one fewer do not.
TEST(BoxDimension, TheFinestSideIsTheLargestThatPointsFill) {
  for (const double dimension : {1.0, 1.5, 2.0})
    for (const int side : {16, 64, 256}) {
      const double points = 16 * 7 * std::pow(side, dimension);
      EXPECT_EQ(finest_side(points + 1, dimension), side);
      EXPECT_EQ(finest_side(points - 1, dimension), side / 2);
    }
}

// 63 and 64 points in four boxes each are one too few, 64 and 64 are enough.
TEST(BoxDimension, ALevelThatLacksOnePointIsNotUsable) {
  const std::vector<std::vector<box_level>> clouds{{{2, 15.75, {4, 4, 4}}, {4, 16, {4, 4, 4}}},
                                                   {{2, 16, {4, 4, 4}}, {4, 16, {4, 4, 4}}}};
  EXPECT_EQ(usable_levels(clouds, hemisphere_bins::side), (std::vector{false, true}));
}

}  // namespace
}  // namespace polhode
