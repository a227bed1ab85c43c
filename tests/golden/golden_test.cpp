// Each writer's text against the committed one, byte for byte.
#include <gtest/gtest.h>

#include "reports/writers/csv.hpp"
#include "reports/writers/html.hpp"
#include "reports/writers/json.hpp"
#include "reports/writers/junit.hpp"
#include "reports/writers/latex.hpp"
#include "reports/writers/markdown.hpp"
#include "reports/writers/series.hpp"
#include "tests/golden/golden_file.hpp"
#include "tests/golden/sample.hpp"

namespace polhode::golden {
namespace {

TEST(golden, results_json) { expect_golden(report::to_json(sample()), "results.json"); }
TEST(golden, measurements_csv) { expect_golden(report::measurements_csv(sample()), "measurements.csv"); }
TEST(golden, verdicts_csv) { expect_golden(report::verdicts_csv(sample()), "verdicts.csv"); }
TEST(golden, report_md) { expect_golden(report::to_markdown(sample()), "report.md"); }
TEST(golden, report_tex) { expect_golden(report::to_latex(sample()), "report.tex"); }
TEST(golden, junit_xml) { expect_golden(report::to_junit(sample()), "junit.xml"); }

TEST(golden, plot_svg) {
  const auto plots = report::plots_of(sample(), "strong");
  ASSERT_EQ(plots.size(), 1u);
  expect_golden(report::to_svg(plots.front()), "plot.svg");
}

TEST(golden, an_empty_result_is_written_too) {
  const report::results nothing;
  EXPECT_NE(report::to_html(nothing).find("\"verdicts\":[]"), std::string::npos);
  EXPECT_NE(report::to_markdown(nothing).find("No claim was tried."), std::string::npos);
  EXPECT_NE(report::to_junit(nothing).find("tests=\"0\""), std::string::npos);
  EXPECT_EQ(report::to_json(report::from_json(report::to_json(nothing))), report::to_json(nothing));
}

TEST(golden, markdown_stays_under_a_megabyte) {
  auto r = sample();
  const auto row = r.measurements.front();
  for (int i = 0; i < 30000; ++i) {
    r.measurements.push_back(row);
    r.measurements.back().observable = "observable " + std::to_string(i);
  }
  const auto text = report::to_markdown(r);
  EXPECT_LT(text.size(), 1'000'000u);
  EXPECT_NE(text.find("Cut here"), std::string::npos);
  EXPECT_NE(text.find("## Provenance"), std::string::npos);
}

// A plot must survive any values: no NaN, no infinity in a coordinate.
TEST(golden, plots_of_extreme_values_have_finite_coordinates) {
  const double extremes[] = {0.0, 5e-324, 1e-300, 1.0, 1e300, 1.7976931348623157e308, -1.7976931348623157e308};
  for (const bool log_x : {false, true})
    for (const bool log_y : {false, true})
      for (const double x : extremes)
        for (const double y : extremes) {
          report::plot p;
          p.log_x = log_x;
          p.log_y = log_y;
          p.slopes = {0.5, 2};
          p.series = {{"a", {{x, y, -y, y, true}}, report::plot_power{1e3, 1e300}, 0}};
          if (x != y) p.series[0].points.push_back({2, 1, {}, {}, true});
          const auto svg = report::to_svg(p);
          EXPECT_EQ(svg.find("nan"), std::string::npos) << x << ' ' << y << svg;
          EXPECT_EQ(svg.find("inf"), std::string::npos) << x << ' ' << y << svg;
        }
}

}  // namespace
}  // namespace polhode::golden
