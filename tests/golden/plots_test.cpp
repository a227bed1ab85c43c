// SPDX-License-Identifier: Apache-2.0
// Which plots there are of a result, and what they name.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "reports/plots/descriptions.hpp"
#include "reports/writers/cost_error.hpp"
#include "reports/writers/series.hpp"
#include "tests/golden/sample.hpp"

namespace polhode::golden {
namespace {

using namespace report;

measurement value(const char* scheme, const char* quantity, const char* observable, double y) {
  return {.experiment = "e", .scheme = scheme, .quantity = quantity, .observable = observable, .value = y};
}

measurement point(const char* scheme, const char* quantity, const char* observable, const char* over, double x,
                  double y) {
  auto m = value(scheme, quantity, observable, y);
  m.set_over({over, x});
  return m;
}

measurement placed(const char* quantity, std::vector<coordinate> at, double y, double half = 0.5) {
  auto m = value("", quantity, "", y);
  m.at = std::move(at);
  m.low = y - half, m.high = y + half;
  return m;
}

std::vector<std::string> ids_of(const std::vector<plot_description>& plots) {
  std::vector<std::string> ids;
  for (const auto& p : plots) ids.push_back(p.id);
  return ids;
}

plot_description only_plot(const results& r) {
  const auto plots = plots_of(r);
  EXPECT_EQ(plots.size(), 1u);
  return plots.empty() ? plot_description{} : plots.front();
}

TEST(plots, of_the_sample) {
  EXPECT_EQ(ids_of(plots_of(sample())),
            (std::vector<std::string>{"strong.error", "weak.error.exp-pi3", "weak.error.a-b-c", "casimir.drift.casimir",
                                      "stability.stable-share", "stability.largest-stable-dt"}));
}

TEST(plots, every_measurement_of_the_sample_has_a_place) {
  const auto r = sample();
  std::set<series_id> shown;
  for (const auto& p : plots_of(r)) {
    for (const auto& line : p.lines) shown.insert(line.series);
    shown.insert(p.levels.begin(), p.levels.end());
  }
  for (const auto& m : r.measurements) EXPECT_TRUE(shown.contains(m.series())) << m.quantity;
}

TEST(plots, a_fitted_curve_is_logarithmic_and_says_what_was_claimed) {
  const auto p = plots_of(sample(), "strong").front();
  EXPECT_TRUE(p.log_x && p.log_y && p.absolute_title.empty());
  EXPECT_EQ(p.slopes, (std::vector<double>{0.5, 1}));
  EXPECT_EQ(p.x, step_size);
  EXPECT_EQ(p.x_title, "step size dt");
  EXPECT_EQ(p.lines.size(), 2u);
  EXPECT_EQ(p.hollow, "dropped by the rule of the fit");
  auto unknown = sample();
  for (auto& v : unknown.verdicts) v.evidence.clear();
  EXPECT_TRUE(plots_of(unknown, "strong").front().slopes.empty());
}

TEST(plots, signs_missing_values_and_levels_are_told) {
  const auto weak = plots_of(sample(), "weak").front();
  EXPECT_EQ(weak.absolute_title, "|error of exp(pi3)|");
  EXPECT_EQ(weak.note, "1 value is missing: not finite.");
  EXPECT_FALSE(weak.log_y);
  const auto drift = plots_of(sample(), "casimir").front();
  ASSERT_EQ(drift.levels.size(), 1u);
  EXPECT_EQ(drift.levels.front().scheme, "");
}

TEST(plots, cells_of_a_map_are_no_plot_over_dt) {
  const auto plots = plots_of(sample(), "stability");
  ASSERT_EQ(plots.size(), 2u);
  EXPECT_EQ(plots[0].kind, plot_kind::map);
  EXPECT_EQ(std::pair(plots[0].x, plots[0].y), std::pair(std::string("dt"), std::string("theta")));
  ASSERT_TRUE(plots[0].lines.front().border);
  EXPECT_EQ(plots[0].lines.front().border->quantity, "largest_stable_dt");
  EXPECT_EQ(plots[1].kind, plot_kind::matrix);
  EXPECT_EQ(plots[1].conditions, std::vector<std::string>{"theta"});
  EXPECT_TRUE(drawable_plots(sample(), "stability").empty());
  EXPECT_EQ(drawable_plots(sample(), "strong").size(), 1u);
}

TEST(plots, what_decays_in_time_stands_over_a_linear_axis) {
  for (const std::string over : {"time", "width of a cell"}) {
    results r;
    for (const double x : {1, 2, 4})
      r.measurements.push_back(point("a", "distance", "", over.c_str(), x, 1 / (x * x * x)));
    const auto p = only_plot(r);
    EXPECT_TRUE(p.log_y);
    EXPECT_EQ(p.log_x, over != "time");
    EXPECT_EQ(p.x_title, over);
  }
}

TEST(plots, one_value_a_scheme_is_a_comparison_and_several_conditions_are_a_matrix) {
  results r;
  for (const char* scheme : {"a", "b"}) r.measurements.push_back(point(scheme, "mean", "energy", step_size, 0.25, 2));
  EXPECT_EQ(only_plot(r).kind, plot_kind::comparison);
  EXPECT_EQ(only_plot(r).title, "mean of energy at dt = 0.25");
  r.verdicts = {{.experiment = "e", .scheme = "a", .expected = 3, .evidence = {r.measurements[0].series()}}};
  EXPECT_FALSE(only_plot(r).claimed) << "of the other nothing is claimed";
  r.verdicts.push_back({.experiment = "e", .scheme = "b", .expected = 3, .evidence = {r.measurements[1].series()}});
  EXPECT_EQ(only_plot(r).claimed, 3);
  r.measurements = {value("a", "rate", "x", 1), value("a", "rate", "y", 1)};
  EXPECT_EQ(only_plot(r).kind, plot_kind::matrix);
}

TEST(plots, cost_and_error_make_a_front_and_accuracies_a_plot_of_their_own) {
  results r;
  for (const double dt : {1.0, 2.0})
    for (const char* quantity : {"cost", "error_at_cost", "steps_per_time"})
      r.measurements.push_back(point("a", quantity, "weak", step_size, dt, dt));
  r.measurements.push_back(point("a", "cost_to_reach", "weak", "accuracy", 0.1, 5));
  r.measurements.push_back(point("a", "cost_to_reach", "weak", "accuracy", 0.01, 4));
  r.measurements.back().value.reset();
  const auto plots = plots_of(r);
  ASSERT_EQ(ids_of(plots), (std::vector<std::string>{"e.cost.weak", "e.reach.weak"}));
  ASSERT_EQ(plots[0].lines.size(), 1u);
  EXPECT_EQ(plots[0].lines[0].across->quantity, "error_at_cost");
  ASSERT_EQ(plots[0].others.size(), 1u);
  EXPECT_EQ(plots[0].others[0].name, "steps");
  ASSERT_EQ(plots[1].lines.size(), 1u);
  EXPECT_EQ(plots[1].x, "accuracy");
  EXPECT_EQ(plots[1].note, "1 target is not reached at the steps that were measured.");
  const auto drawn = drawable_plots(r, "e");
  ASSERT_EQ(drawn.size(), 1u);
  EXPECT_EQ(drawn[0].series.at(0).points.size(), 2u);
}

TEST(cost_table, a_line_is_a_kind_and_an_accuracy_with_its_own_next) {
  results r;
  const auto reached = [&](const char* quantity, double accuracy, double value, bool cheapest) {
    auto m = point("a", quantity, "weak", step_size, 0.5, value);
    m.set_over({"accuracy", accuracy});
    m.used = cheapest;
    r.measurements.push_back(m);
  };
  for (const double accuracy : {0.01, 0.1}) {  // both at one step size
    reached("cost_to_reach", accuracy, 1 / accuracy, true);
    reached("cost_of_next", accuracy, 1 + accuracy, false);
  }
  r.measurements.push_back(point("b", "cost_to_reach", "weak", "accuracy", 0.1, 99));
  const auto lines = cost_table_of(r, "e");
  ASSERT_EQ(lines.size(), 2u) << "of schemes that are not the cheapest there is no line";
  EXPECT_EQ(std::pair(lines[0].what, lines[1].what), std::pair(std::string("weak 1e-01"), std::string("weak 1e-02")));
  ASSERT_TRUE(lines[0].next && lines[1].next);
  EXPECT_EQ(std::pair(lines[0].next->value, lines[1].next->value), std::pair(std::optional(1.1), std::optional(1.01)));
}

TEST(plots, of_the_equation_over_its_parameters) {
  results r;
  for (const double sigma : {1.0, 4.0}) {
    for (const double theta : {1.0, 2.0})
      r.measurements.push_back(placed("lambda_1 map", {{"sigma", sigma}, {"theta", theta}}, sigma - theta));
    r.measurements.push_back(placed("border", {{"sigma", sigma}}, sigma));
    r.measurements.back().unit = "theta";
    r.measurements.push_back(value("", "rate", "", 1));
    r.measurements.back().at = {{"sigma", sigma}};
  }
  r.measurements.push_back(value("", "dimension", "", 1.5));
  const auto plots = plots_of(r);
  ASSERT_EQ(ids_of(plots), (std::vector<std::string>{"e.lambda-1-map", "e.border", "e.facts", "e.conditions"}));
  EXPECT_EQ(plots[0].title, "lambda_1 over sigma and theta");
  EXPECT_TRUE(plots[0].diverging && plots[0].log_x && !plots[0].log_y && plots[0].lines.front().border);
  EXPECT_EQ(plots[1].title, "border: theta over sigma");
  EXPECT_EQ(plots[2].lines.front().series.quantity, "dimension");
  EXPECT_EQ(plots[3].conditions, std::vector<std::string>{"sigma"});
}

TEST(plots, ids_are_unique_and_fit_for_an_address) {
  results r;
  for (const char* quantity : {"A b", "a_b", "Π"})
    for (const double x : {1, 2}) r.measurements.push_back(point("s", quantity, "", step_size, x, x));
  EXPECT_EQ(ids_of(plots_of(r)), (std::vector<std::string>{"e.a-b", "e.a-b.2", "e.x"}));
}

}  // namespace
}  // namespace polhode::golden
