// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/density_picture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <polhode/vec.hpp>

#include "ensemble/observing/sphere_bins.hpp"
#include "reports/writers/npy.hpp"

namespace polhode {
namespace {

constexpr int side = hemisphere_bins::side;
constexpr double pi = std::numbers::pi;

struct place {
  double x, y;
};

/// The middle of the pixels that show a density; the marks of the axes are none.
place middle(const report::raster& picture, int left, int right, int top, int bottom) {
  place sum{0, 0};
  double count = 0;
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x)
      if (picture.pixels[static_cast<std::size_t>(y * picture.width + x)] >= 7) {
        sum.x += x + 0.5;
        sum.y += y + 0.5;
        ++count;
      }
  return {sum.x / count, sum.y / count};
}

report::raster picture_of(const vec<double, 3>& n) {
  report::simulation s;
  s.bodies = 1;
  s.scheme.name = "strang";
  report::ensemble_snapshot shot;
  shot.side = side;
  shot.picture.resize(hemisphere_bins::count);
  shot.picture[static_cast<std::size_t>(hemisphere_bins::of(n[0], n[1], n[2]))] = 1;
  return report::density_picture(side).paint(s, shot);
}

/// Snyder (1987), eqs. (31-1) to (31-4), by bisection: the other way round than the picture is made.
place mollweide(double longitude, double z) {
  double low = -pi / 2, high = pi / 2;
  for (int i = 0; i < 60; ++i) {
    const double a = 0.5 * (low + high);
    (2 * a + std::sin(2 * a) < pi * z ? low : high) = a;
  }
  return {60 + 540 * (1 + longitude / pi * std::cos(low)), 90 + 270 * (1 - std::sin(low))};
}

TEST(DensityPicture, ShowsABodyWhereItIs) {
  for (const double z : {-0.9, -0.3, 0.2, 0.7})
    for (const double longitude : {-2.9, -1.2, -0.4, 0.3, 1.1, 2.5}) {
      const double r = std::sqrt(1 - z * z);
      const vec<double, 3> n{{r * std::cos(longitude), r * std::sin(longitude), z}};
      const auto picture = picture_of(n);
      const auto map = middle(picture, 60, 1140, 90, 630), expected = mollweide(longitude, z);
      EXPECT_NEAR(map.x, expected.x, 2.5) << z << ' ' << longitude;
      EXPECT_NEAR(map.y, expected.y, 2.5) << z << ' ' << longitude;
      const int left = z > 0 ? 60 : 545;
      const auto disc = middle(picture, left, left + 440, 680, 1120);
      EXPECT_NEAR(disc.x, left + 220 * (1 + (z > 0 ? n[0] : -n[0])), 2) << z << ' ' << longitude;
      EXPECT_NEAR(disc.y, 680 + 220 * (1 - n[1]), 2) << z << ' ' << longitude;
    }
}

TEST(DensityPicture, ReachesTheLastColourAndNoFurther) {
  report::simulation s;
  s.bodies = 4'000'000'000;
  report::ensemble_snapshot shot;
  shot.side = side;
  shot.picture.assign(hemisphere_bins::count, 1);
  for (int y = 220; y < 292; ++y)
    for (int x = 220; x < 292; ++x) shot.picture[static_cast<std::size_t>(y * side + x)] = 4'000'000'000 / (72 * 72);
  const auto picture = report::density_picture(side).paint(s, shot);
  EXPECT_EQ(picture.palette.size(), 256u);
  EXPECT_EQ(picture.pixels[static_cast<std::size_t>((680 + 195) * picture.width + 60 + 245)], 255);
}

// Matplotlib's tables at 0, 64, 128, 192, 255 of 255; the polynomials are within 3 %.
TEST(ColourMaps, AreThoseOfTheirTables) {
  const std::vector<std::vector<report::colour>> tables{
      {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}},
      {{0, 0, 4}, {81, 18, 124}, {183, 55, 121}, {252, 137, 97}, {252, 253, 191}},
      {{0, 34, 78}, {67, 78, 108}, {125, 124, 120}, {188, 174, 108}, {254, 232, 56}}};
  ASSERT_EQ(report::colour_maps().size(), tables.size());
  for (std::size_t m = 0; m < tables.size(); ++m)
    for (std::size_t i = 0; i < 5; ++i) {
      const auto found = report::colour_maps()[m].at(std::min(1.0, 64.0 * static_cast<double>(i) / 255));
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(found[k], tables[m][i][k], 8) << report::colour_maps()[m].name << ' ' << i;
    }
}

TEST(ColourMaps, GrowEvenlyBrighterFromWhatIsEmpty) {
  const auto light = [](const report::colour& c) {  // CIE L*, Rec. 709 primaries
    double y = 0;
    const double weights[] = {0.2126, 0.7152, 0.0722};
    for (std::size_t k = 0; k < 3; ++k) {
      const double v = c[k] / 255.0;
      y += weights[k] * (v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
    }
    return 116 * std::cbrt(y) - 16;
  };
  ASSERT_FALSE(report::colour_maps().empty());
  for (const auto& map : report::colour_maps()) {
    double before = light(map.at(map.first));
    EXPECT_GE(before, 9) << map.name;  // the sphere where no body is: 9
    const double whole = light(map.at(1)) - before;
    for (double t = 0.1; t < 1.01; t += 0.1) {
      const double now = light(map.at(std::min(1.0, map.first + (1 - map.first) * t)));
      EXPECT_NEAR((now - before) / whole, 0.1, 0.05) << map.name << ' ' << t;
      before = now;
    }
  }
}

TEST(DensityPicture, ChangesItsColoursAndNothingElse) {
  report::simulation s;
  s.bodies = 1;
  report::ensemble_snapshot shot;
  shot.side = side;
  shot.picture.resize(hemisphere_bins::count);
  const auto first = report::density_picture(side).paint(s, shot);
  ASSERT_GT(report::colour_maps().size(), 1u);
  for (const auto& map : report::colour_maps().subspan(1)) {
    const auto other = report::density_picture(side, map).paint(s, shot);
    EXPECT_EQ(other.pixels, first.pixels);
    EXPECT_NE(other.palette, first.palette);
  }
}

TEST(Npy, TurnsColumnsIntoRows) {
  const std::vector<double> columns{1, 2, 3, 10, 20, 30};  // two columns
  const auto file = report::to_npy_rows(columns, 2);
  EXPECT_NE(file.find("'descr': '<f8', 'fortran_order': False, 'shape': (3, 2, )"), std::string::npos);
  ASSERT_EQ(file.size() % 64, 48u);
  const std::string ten("\0\0\0\0\0\0\x24\x40", 8), one("\0\0\0\0\0\0\xF0\x3F", 8);
  EXPECT_EQ(file.substr(file.size() - 48, 16), one + ten);
}

}  // namespace
}  // namespace polhode
