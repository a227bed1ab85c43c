// SPDX-License-Identifier: Apache-2.0
// Each writer's text against the committed one, byte for byte.
#include <gtest/gtest.h>

#include "reports/writers/csv.hpp"
#include "reports/writers/html.hpp"
#include "reports/writers/json.hpp"
#include "reports/writers/junit.hpp"
#include "reports/writers/latex.hpp"
#include "reports/writers/markdown.hpp"
#include "reports/writers/packed.hpp"
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

TEST(golden, an_empty_result_is_written_too) {
  const report::results nothing;
  EXPECT_NE(report::to_html(nothing).find(report::packed(report::to_json(nothing))), std::string::npos);
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

}  // namespace
}  // namespace polhode::golden
