// SPDX-License-Identifier: Apache-2.0
// The table of `work_precision`, which the page shows, and `select` answer one question: the same scheme at the same
// step, or one whose cost the clock cannot tell from it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "run/choose.hpp"
#include "run/verify.hpp"

namespace polhode {
namespace {

/// Between two runs' timings of one kernel, at its worst.
constexpr double clock_share = 0.15;
/// The table's steps lie on a power law between levels, those of `select` on a ladder of its own.
constexpr double step_share = 0.3;

struct table_row {
  double dt = 0, cost = 0;
  bool coarsest = false;
};

/// By scheme, the cheapest first in cost.
std::map<std::string, table_row> table_of(const report::results& r, const std::string& what, double accuracy) {
  std::map<std::string, table_row> out;
  for (const auto& m : r.measurements)
    if (m.quantity == "cost_to_reach" && m.observable == what && m.abscissa() == accuracy && m.value)
      out[m.scheme] = {m.dt().value(), *m.value, m.status == "at the coarsest dt measured"};
  return out;
}

struct question {
  const char *goal, *experiment, *table;
  bool whole;  ///< steps fill the horizon in `select`; the table's power law knows of no such thing
};

/// The next shorter step of which a whole number fills the time.
double whole_step(double time, double dt) { return time / std::ceil(time / dt * (1 - 1e-9)); }

class OneAnswer : public testing::TestWithParam<question> {};

TEST_P(OneAnswer, IsGivenByTheTableAndBySelect) {
  const auto scene = load_scene("paper");
  verify_options options;
  options.experiments = {GetParam().experiment, "work_precision"};
  options.effort = effort::quick;
  options.threads = 2;
  const auto report = verify(scene, options);
  int compared = 0;
  for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
    auto table = table_of(report, GetParam().table, tolerance);
    if (table.empty()) continue;
    if (GetParam().whole)
      for (auto& [_, row] : table) {
        const double dt = whole_step(scene.horizon, row.dt);
        row.cost *= row.dt / dt;
        row.dt = dt;
      }
    select_options asked;
    asked.goal = GetParam().goal;
    asked.tolerance = tolerance;
    asked.threads = 2;
    const auto found = select(scene, asked);
    ASSERT_TRUE(found.winner) << found.reason;
    const auto& w = *found.winner;
    ASSERT_TRUE(table.contains(w.scheme)) << w.scheme << " is not in the table at " << tolerance;
    const auto& same = table.at(w.scheme);
    ++compared;
    if (same.coarsest) {
      EXPECT_GE(w.dt, same.dt * (1 - step_share)) << w.scheme << ' ' << tolerance;
      continue;
    }
    EXPECT_NEAR(std::log(w.dt / same.dt), 0, step_share) << w.scheme << ' ' << tolerance;
    for (const auto& [scheme, row] : table)
      EXPECT_GE(row.cost, same.cost * (1 - clock_share - step_share))
          << scheme << " is cheaper than " << w.scheme << " at " << tolerance;
  }
  EXPECT_GE(compared, 2);
}

INSTANTIATE_TEST_SUITE_P(Select, OneAnswer,
                         testing::Values(question{"weak", "weak", "weak", true},
                                         question{"stationary", "gibbs", "stationary", false},
                                         question{"energy", "energy", "energy_law", true},
                                         question{"strong", "strong", "strong", true}),
                         [](const auto& one) { return std::string(one.param.goal); });

}  // namespace
}  // namespace polhode
