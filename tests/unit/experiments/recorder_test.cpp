// SPDX-License-Identifier: Apache-2.0
// What an experiment writes stands in the results as it was written.
#include "experiments/common/recorder.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace polhode {
namespace {

const quantity error{"error", "energy", "J", "sampled"};

TEST(Recorder, ARowIsWrittenOnceWithTheNamesOfBoth) {
  report::results out;
  const auto id = recorder("strong", "heun", out).value(error, at_dt(0.25), 3, 2, 4);
  ASSERT_EQ(out.measurements.size(), 1u);
  const auto& row = out.measurements[0];
  EXPECT_EQ(row.series(), id);
  EXPECT_EQ(id, (report::series_id{"strong", "heun", "error", "energy", report::step_size}));
  EXPECT_EQ(row.value, 3);
  EXPECT_EQ(row.low, 2);
  EXPECT_EQ(row.high, 4);
  EXPECT_EQ(row.dt(), 0.25);
  EXPECT_EQ(row.unit, "J");
  EXPECT_EQ(row.method, "sampled");
  EXPECT_EQ(row.status, "ok");
}

TEST(Recorder, AnIntervalIsWrittenWithItsEnds) {
  report::results out;
  recorder record("strong", "heun", out);
  record.value(error, interval_estimate{3, 2, 4});
  record.value(error, at_dt(0.5), interval_estimate{6, 5, 7});
  ASSERT_EQ(out.measurements.size(), 2u);
  for (int i : {0, 1}) {
    EXPECT_EQ(out.measurements[i].value, 3 * (i + 1)) << i;
    EXPECT_EQ(out.measurements[i].low, 2 + 3 * i) << i;
    EXPECT_EQ(out.measurements[i].high, 4 + 3 * i) << i;
  }
  EXPECT_EQ(out.measurements[0].over, "");
  EXPECT_EQ(out.measurements[1].dt(), 0.5);
}

TEST(Recorder, WhatIsNotFiniteIsAStatus) {
  for (const double value : {double(NAN), double(INFINITY), -double(INFINITY)}) {
    const auto row = row_of(error, value, 1, 2);
    EXPECT_EQ(row.status, "not finite") << value;
    EXPECT_FALSE(row.value || row.low || row.high) << value;
  }
}

TEST(Recorder, ASeriesHasItsPointsItsFitAndWhatThatUsed) {
  report::results out;
  recorder record("weak", "strang", out);
  curve c{error};
  c.at = {{"noise", 2, "1"}};
  c.add(0.5, 4);
  c.add(0.25, interval_estimate{1, 0.5, 1.5});
  c.points.push_back({0.125, NAN, {}, {}, "below the floor"});
  order_fit found;
  found.order = 2;
  found.low = 1.9;
  found.high = 2.1;
  found.prefactor = 16;
  found.used = {false, true, false};
  found.rule = "why";
  const auto id = record.series(c, found);
  ASSERT_EQ(out.measurements.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(out.measurements[i].series(), id) << i;
    EXPECT_EQ(out.measurements[i].dt(), c.points[i].at) << i;
    EXPECT_EQ(out.measurements[i].at_coordinate("noise"), 2) << i;
    EXPECT_EQ(out.measurements[i].used, found.used[i]) << i;
  }
  EXPECT_EQ(out.measurements[0].value, 4);
  EXPECT_EQ(out.measurements[1].low, 0.5);
  EXPECT_EQ(out.measurements[1].status, "ok");
  EXPECT_EQ(out.measurements[2].status, "not finite");
  ASSERT_EQ(out.fits.size(), 1u);
  const auto& fit = out.fits[0];
  EXPECT_EQ(fit.series(), id);
  EXPECT_EQ(fit.order, 2);
  EXPECT_EQ(fit.low, 1.9);
  EXPECT_EQ(fit.high, 2.1);
  EXPECT_EQ(fit.prefactor, 16);
  EXPECT_EQ(fit.rule, "why");
}

TEST(Recorder, PointsWithoutAFitSayThemselvesWhetherTheyAreUsedAndWhatTheyAre) {
  report::results out;
  curve c{error};
  c.points = {{0.5, 1, {}, {}, "ok", true}, {0.25, 1, {}, {}, "below the floor", false}};
  recorder("weak", "strang", out).series(c);
  ASSERT_EQ(out.measurements.size(), 2u);
  EXPECT_TRUE(out.measurements[0].used);
  EXPECT_FALSE(out.measurements[1].used);
  EXPECT_EQ(out.measurements[1].status, "below the floor");
  EXPECT_TRUE(out.fits.empty());
}

TEST(Recorder, AVerdictNamesWhatDecidesIt) {
  report::results out;
  recorder record("weak", "", out);
  const auto id = record.id(error, report::step_size), own = record.id(error);
  record.of("magnus").verdict("order", {.kind = report::verdict_kind::holds, .reason = "so", .evidence = {own}}, {id});
  ASSERT_EQ(out.verdicts.size(), 1u);
  const auto& v = out.verdicts[0];
  EXPECT_EQ(v.experiment, "weak");
  EXPECT_EQ(v.scheme, "magnus");
  EXPECT_EQ(v.claim, "order");
  EXPECT_EQ(v.reason, "so");
  EXPECT_EQ(v.kind, report::verdict_kind::holds);
  EXPECT_EQ(v.evidence, (std::vector<report::series_id>{own, id}));
}

TEST(Recorder, ARemarkGoesToTheFitsOrElseToTheVerdicts) {
  report::results out;
  recorder before("weak", "heun", out), with_fit("weak", "magnus", out), without("weak", "strang", out);
  before.verdict("order", {.reason = "as it was"});
  with_fit.fit(with_fit.id(error, report::step_size), 1, 1, 1, 1, "rule");
  with_fit.verdict("order", {.reason = "as it was"});
  with_fit.remark("remark");
  without.verdict("order", {.reason = "reason"});
  without.remark("remark");
  EXPECT_EQ(out.fits.at(0).rule, "rule; remark");
  EXPECT_EQ(out.verdicts.at(0).reason, "as it was");
  EXPECT_EQ(out.verdicts.at(1).reason, "as it was");
  EXPECT_EQ(out.verdicts.at(2).reason, "reason; remark");
}

}  // namespace
}  // namespace polhode
