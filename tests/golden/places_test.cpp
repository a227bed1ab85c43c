// Curves and maps over places: what is gathered, what is drawn, and that no value breaks the picture.
#include <gtest/gtest.h>

#include <limits>

#include "reports/writers/field.hpp"
#include "reports/writers/places.hpp"
#include "tests/golden/golden_file.hpp"
#include "tests/golden/sample.hpp"

namespace polhode::golden {
namespace {

using namespace report;

measurement stands(const char* quantity, const std::string& place, std::optional<double> value,
                   const char* unit = "1") {
  measurement m;
  m.experiment = "lyapunov";
  m.quantity = quantity;
  m.observable = place;
  m.value = m.low = m.high = value;
  m.unit = unit;
  if (!value) m.status = "not converged <here>";
  return m;
}

// Powers of two, so that files are the same everywhere.
results border_and_map() {
  results r;
  const std::string sigma[] = {"0.25", "0.5", "1", "2"}, theta[] = {"0", "1", "2"};
  for (int i = 0; i < 4; ++i) {
    r.measurements.push_back(
        stands("border of chaos", "sigma=" + sigma[i], i == 3 ? std::nullopt : std::optional(0.5 + i / 4.0), "theta"));
    for (int j = 0; j < 3; ++j)
      r.measurements.push_back(stands("lambda_1 map", "sigma=" + sigma[i] + " theta=" + theta[j],
                                      i == 3 && j == 2 ? std::nullopt : std::optional((1 + i - 2.0 * j) / 16),
                                      "per time"));
  }
  r.measurements.push_back(stands("lambda_1", "", 0.25, "per time"));
  r.measurements.back().low = 0.125;
  r.measurements.back().high = 0.375;
  return r;
}

TEST(places, map_svg) {
  const auto maps = place_maps_of(border_and_map(), "lyapunov");
  ASSERT_EQ(maps.size(), 1u);
  expect_golden(to_svg(maps.front()), "map.svg");
}

TEST(places, heat_map_svg) {
  const auto maps = maps_of(sample(), "stability");
  ASSERT_EQ(maps.size(), 1u);
  expect_golden(to_svg(maps.front()), "heat_map.svg");
}

TEST(places, are_gathered) {
  const auto r = border_and_map();
  const auto curves = place_curves_of(r, "lyapunov");
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_EQ(curves[0].x_title, "σ");
  EXPECT_EQ(curves[0].y_title, "θ");
  EXPECT_TRUE(curves[0].log_x && !curves[0].log_y);
  ASSERT_EQ(curves[0].series.at(0).points.size(), 3u);  // one has no value
  EXPECT_EQ(curves[0].series[0].points[1].x, 0.5);
  EXPECT_EQ(curves[0].series[0].points[1].y, 0.75);
  const auto map = place_maps_of(r, "lyapunov").at(0);
  EXPECT_EQ(map.x_title + map.y_title, "σθ");
  EXPECT_EQ(map.cells.size(), 12u);
  EXPECT_EQ(map.curves.at(0).points.size(), 3u);
  EXPECT_EQ(facts_of(r, "lyapunov").size(), 1u);
  EXPECT_TRUE(place_maps_of(r, "strong").empty());
}

TEST(places, other_observables_are_none) {
  results r;
  for (const char* text : {"", "energy", "exp(pi3)", "a=b", "=1", "a=", "a=1 b", "a=1  b=2", "a=nan", "a=1 b=2 c=3"})
    r.measurements.push_back(stands("q", text, 1));
  EXPECT_TRUE(place_curves_of(r, "lyapunov").empty());
  EXPECT_TRUE(place_maps_of(r, "lyapunov").empty());
  EXPECT_EQ(facts_of(r, "lyapunov").size(), 1u);
}

TEST(places, belong_to_no_scheme) {
  const auto r = sample();
  for (const auto& e : r.experiments)
    EXPECT_TRUE(place_curves_of(r, e.name).empty() && place_maps_of(r, e.name).empty()) << e.name;
}

// White where the value is zero, one colour a sign, deepest at the ends; a cell without a value is neither.
TEST(places, colours_tell_the_sign) {
  value_map m;
  m.cells = {{1, 1, 0.0, "ok"}, {2, 1, 4.0, "ok"}, {3, 1, -1.0, "ok"}, {4, 1, {}, "missing"}};
  const auto svg = to_svg(m);
  const auto colour_at = [&](const std::string& x) {
    const auto title = svg.find("<title> " + x + ",");
    return svg.substr(svg.rfind("fill=\"#", title) + 7, 6);
  };
  EXPECT_EQ(colour_at("1"), "ffffff");
  EXPECT_EQ(colour_at("2"), "00569c");
  EXPECT_EQ(colour_at("3"), "e2a780");  // half way to the deepest
  EXPECT_EQ(colour_at("4"), "9aa1a9");
}

TEST(places, extreme_values_have_finite_coordinates) {
  const double extremes[] = {0.0, 5e-324, 1e-300, 1.0, 1e300, 1.7976931348623157e308, -1.7976931348623157e308};
  for (const bool logarithmic : {false, true})
    for (const double x : extremes)
      for (const double value : extremes) {
        if (logarithmic && x <= 0) continue;
        value_map m;
        m.log_x = logarithmic;
        m.cells = {{x, x, value, "ok"}, {1, 1, 1, "ok"}, {2, x, {}, "missing"}};
        m.curves = {{"a", {{x, x, {}, {}, false}}}};
        const auto svg = to_svg(m);
        EXPECT_EQ(svg.find("nan"), std::string::npos) << x << ' ' << value << svg;
        EXPECT_EQ(svg.find("inf"), std::string::npos) << x << ' ' << value << svg;
      }
  EXPECT_NE(to_svg(value_map{}).find("</svg>"), std::string::npos);
}

}  // namespace
}  // namespace polhode::golden
