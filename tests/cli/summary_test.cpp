// SPDX-License-Identifier: Apache-2.0
// What is printed after a run, at any width, and the exit code that goes with it.
#include "cli/terminal/summary.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "cli/terminal/forecast_table.hpp"
#include "cli/terminal/layout.hpp"
#include "cli/terminal/reproduction_table.hpp"
#include "reports/model/text.hpp"

namespace {

using namespace polhode;
using report::verdict_kind;

report::verdict verdict(std::string experiment, std::string scheme, verdict_kind kind) {
  return {std::move(experiment), std::move(scheme), "order", 1, .5, .45, .55, kind, "a reason in some words"};
}

report::results results_with(const std::vector<verdict_kind>& kinds) {
  report::results r;
  r.scene.name = "a scene whose name is far too long for a narrow terminal to hold";
  r.schemes.resize(2);
  r.schemes[0].name = "heun_projected";
  r.schemes[1].name = "implicit_midpoint";
  r.experiments = {{"casimir", "", {}}, {"work_precision", "", {}}, {"gibbs", "", {}}};
  for (const auto kind : kinds) r.verdicts.push_back(verdict("work_precision", "implicit_midpoint", kind));
  r.skipped = {{"gibbs", "", "without noise there is no stationary law to compare with"},
               {"work_precision", "heun_projected", "not asked"}};
  return r;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in{text};
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

TEST(exit_code, is_the_worst_of_the_verdicts) {
  using enum verdict_kind;
  struct {
    std::vector<verdict_kind> kinds;
    int code;
  } const cases[] = {{{}, 0},        {{holds, skipped}, 0},        {{skipped, not_tried}, 0},
                     {{refuted}, 1}, {{inconclusive, refuted}, 1}, {{holds, inconclusive, skipped}, 3}};
  for (const auto& c : cases) EXPECT_EQ(cli::exit_code(std::vector{results_with(c.kinds)}), c.code);
  EXPECT_EQ(cli::exit_code(std::vector{results_with({inconclusive}), results_with({refuted})}), 1);
  EXPECT_EQ(cli::exit_code(std::vector{results_with({inconclusive}), results_with({holds})}), 3);
}

TEST(summary, fits_the_width_and_breaks_between_words) {
  using enum verdict_kind;
  const auto r = results_with({holds, refuted, inconclusive, not_tried, skipped});
  std::vector<std::string> words;
  for (const std::size_t width : {40, 50, 56, 65, 66, 80, 200}) {
    const auto text = cli::summary(r, width);
    for (const auto& line : lines_of(text)) EXPECT_LE(display_width(line), width) << line;
    for (const std::string word : {"work_precision", "implicit_midpoint", "stationary", "[0.45,", "reason"})
      EXPECT_NE(text.find(word), text.npos) << word << " at " << width;
  }
}

TEST(summary, counts_every_verdict_once) {
  using enum verdict_kind;
  const auto lines =
      lines_of(cli::summary(results_with({holds, holds, refuted, inconclusive, not_tried, skipped}), 80));
  EXPECT_EQ(lines[1], "experiment      holds  refuted  inconclusive  not tried  skipped");
  EXPECT_EQ(lines[2], "casimir             0        0             0          0        0");
  EXPECT_EQ(lines[3], "work_precision      2        1             1          1        2");
  EXPECT_EQ(lines[4], "gibbs               0        0             0          0        2");
  EXPECT_EQ(lines.back(), "2 holds, 1 refuted, 1 inconclusive, 1 not tried, 4 skipped");
}

TEST(summary, tells_why_schemes_do_not_run_and_passes_no_run_of_none) {
  auto r = results_with({verdict_kind::holds});
  r.skipped.push_back({"", "mine", "knows bodies alone"});
  r.skipped.push_back({"", "yours", "knows bodies alone"});
  const auto text = cli::summary(r, 80);
  EXPECT_NE(text.find("not run here: mine, yours: knows bodies alone\n"), std::string::npos) << text;
  for (const auto& line : lines_of(text)) EXPECT_NE(line.find_first_not_of(" 0123456789"), std::string::npos) << text;
  EXPECT_EQ(cli::exit_code(std::vector{r}), 0);
  r.schemes.clear();
  r.verdicts.clear();
  EXPECT_EQ(cli::exit_code(std::vector{r}), 3);
}

TEST(summary, names_few_of_many) {
  const auto text = cli::summary(results_with(std::vector(40, verdict_kind::refuted)), 80);
  EXPECT_NE(text.find("and 28 more: see the report"), text.npos) << text;
}

report::reproduction reproduction_with(report::agreement verdict) {
  report::reproduction r{
      .name = "case", .title = "a title", .source = "a source", .scene = "", .notes = {}, .numbers = {}};
  report::reproduced_number n;
  n.quantity = "a quantity whose name is rather long";
  n.published = 1;
  n.ours = 2;
  n.verdict = verdict;
  n.why = "a reason in some words";
  r.numbers = {n};
  return r;
}

TEST(reproductions, end_with_one_only_where_a_number_should_agree) {
  using enum report::agreement;
  EXPECT_EQ(cli::exit_code(std::vector{reproduction_with(agrees), reproduction_with(explained)}), 0);
  EXPECT_EQ(cli::exit_code(std::vector{reproduction_with(differs), reproduction_with(agrees)}), 1);
}

TEST(reproductions, fit_and_give_reasons_for_what_differs) {
  for (const std::size_t width : {40U, 80U, 120U})
    for (const auto verdict : report::agreements) {
      const auto text = cli::to_text(std::vector{reproduction_with(verdict)}, width);
      for (const auto& line : lines_of(text)) EXPECT_LE(display_width(line), width) << line;
      EXPECT_EQ(text.find("reason") != text.npos, verdict != report::agreement::agrees) << text;
    }
}

TEST(forecasts, name_the_dearest_first_with_two_digits) {
  const std::vector<expected_cost> costs{{"casimir", 0.2}, {"weak", 12.34}, {"gibbs", 600}, {"modified", 0}};
  EXPECT_EQ(cli::forecast_table("a", costs, 2, 80),
            "experiment  expected CPU time\n"
            "gibbs       10 min\n"
            "weak        12 s\n"
            "casimir     below 1 s\n"
            "modified    none\n"
            "a: about 5.1 min on 2 threads\n");
}

TEST(forecasts, are_told_beforehand_where_a_run_is_long) {
  const std::vector<expected_cost> costs{{"strong", 59}, {"energy", 1}, {"weak", 7200}};
  EXPECT_EQ(cli::long_run_note("a", costs, 1, 80),
            "a: about 2.0 h on 1 thread: weak 2.0 h (--budget ends it in time)\n");
  EXPECT_EQ(cli::long_run_note("a", std::span(costs).first(2), 1, 80),
            "a: about 60 s on 1 thread: strong 59 s (--budget ends it in time)\n");
  EXPECT_EQ(cli::long_run_note("a", std::span(costs).first(2), 2, 80), "");
  EXPECT_EQ(cli::long_run_note("a", {}, 2, 80), "");
  for (const auto& line : lines_of(cli::long_run_note("a scene with a name", costs, 64, 40)))
    EXPECT_LE(display_width(line), 40U) << line;
}

TEST(layout, names_stand_beside_or_above) {
  const std::vector<cli::entry> list{{"heun", "one two\nthree"}, {"lie_heun", "four"}};
  EXPECT_EQ(cli::entries(list, 80), "heun      one two\n          three\nlie_heun  four\n");
  EXPECT_EQ(cli::entries(list, 20), "heun\n  one two\n  three\nlie_heun\n  four\n");
}

TEST(layout, a_word_is_never_cut) {
  EXPECT_EQ(cli::wrapped("aa bb cccccccccc d", 5, 1), "aa bb\n cccccccccc\n d");
  EXPECT_EQ(cli::wrapped("", 5), "");
}

}  // namespace
