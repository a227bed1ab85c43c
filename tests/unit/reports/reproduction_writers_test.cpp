// SPDX-License-Identifier: Apache-2.0
// How published numbers and ours are written, in each format.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "reports/writers/reproduction_html.hpp"
#include "reports/writers/reproduction_json.hpp"
#include "reports/writers/reproduction_markdown.hpp"
#include "reports/writers/reproduction_numbers.hpp"
#include "reports/writers/reproduction_plot.hpp"

namespace polhode::report {
namespace {

reproduced_number sample() {
  reproduced_number n;
  n.quantity = "a <b> & | c";
  n.published = 0.589;
  n.least = 0.5885;
  n.most = 0.5895;
  n.ours = 0.5104;
  n.low = 0.5094;
  n.high = 0.5114;
  n.verdict = agreement::explained;
  n.why = "x < y";
  return n;
}

reproduction whole() {
  reproduction r;
  r.name = "case";
  r.title = "A <title>";
  r.source = "somebody";
  r.scene = "name = \"<x>\"\n";
  r.numbers = {sample()};
  r.curves = {{"curve", "x", "y", "them", "us", true, {{1, 1, 2}, {10, 100, 200}, {0, 1, 1}}}};
  return r;
}

TEST(ReproductionWriters, NumbersHaveTheDigitsOfTheirIntervals) {
  auto n = sample();
  EXPECT_EQ(shown_published(n), "0.5890 ± 0.0005");
  EXPECT_EQ(shown_ours(n), "0.510 ± 0.001");
  EXPECT_EQ(shown_difference(n), "by 0.079");
  n.high = 0.6;
  EXPECT_EQ(shown_ours(n), "0.5104 [0.5094, 0.6]");
  n.high = n.low = n.ours;
  EXPECT_EQ(shown_ours(n), "0.510400");  // a hundredth of the tolerance
  n.published.reset();
  n.least.reset();
  EXPECT_EQ(shown_published(n), "at most 0.5895");
  n.verdict = agreement::agrees;
  EXPECT_EQ(shown_difference(n), "");
}

TEST(ReproductionWriters, TextOfOthersStaysText) {
  const auto page = to_html(std::vector{whole()});
  EXPECT_EQ(page.find("<b>"), page.npos);
  EXPECT_NE(page.find("a &lt;b&gt; &amp; | c"), page.npos);
  EXPECT_NE(page.find("A &lt;title&gt;"), page.npos);
  EXPECT_NE(page.find("differs, explained"), page.npos);
  const auto text = to_markdown(std::vector{whole()});
  EXPECT_EQ(text.find("<b>"), text.npos);
  EXPECT_NE(text.find("| 0.5890 ± 0.0005 | 0.510 ± 0.001 | differs, explained by 0.079 |"), text.npos);
}

TEST(ReproductionWriters, JsonHoldsNoNumberThatIsNone) {
  auto r = whole();
  r.numbers[0].ours = std::numeric_limits<double>::quiet_NaN();
  const auto text = to_json(std::vector{r});
  EXPECT_EQ(text.find("nan"), text.npos);
  EXPECT_NE(text.find("\"ours\": null"), text.npos);
  EXPECT_NE(text.find("\"tolerance\": 0.0005"), text.npos);
}

// What has no logarithm is not drawn.
TEST(ReproductionWriters, CurvesAreDrawn) {
  const auto drawn = to_svg(whole().curves[0]);
  std::size_t circles = 0;
  for (auto at = drawn.find("<circle"); at != drawn.npos; at = drawn.find("<circle", at + 1)) ++circles;
  EXPECT_EQ(circles, 2U);
  EXPECT_EQ(drawn.find("nan"), drawn.npos);
  EXPECT_EQ(to_svg({"t", "x", "y", "a", "b", true, {{0, 1, 1}}}), "");
}

}  // namespace
}  // namespace polhode::report
