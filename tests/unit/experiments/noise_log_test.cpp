// SPDX-License-Identifier: Apache-2.0
// The noise that a run has heard: block by block, one block after another, or path by path.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/noise_verdict.hpp"
#include "problem/drives.hpp"
#include "run/bind_scene.hpp"
#include "scene/scene.hpp"

namespace polhode {
namespace {

constexpr int blocks = 4, steps = 64, pieces = 3;
constexpr double dt = 0.1;

/// Calls with(block, first step, increments), block by block, piece by piece.
template <class With>
void over_blocks(const model& m, With with) {
  increment_buffer buffer(m, steps, true, {});
  for (int block = 0; block < blocks; ++block)
    for (int piece = 0; piece < pieces; ++piece)
      with(block, piece * steps,
           buffer.fill(7, static_cast<std::uint64_t>(block * block_lanes), static_cast<std::uint64_t>(piece * steps),
                       steps, dt));
}

report::results report_of(const noise_log& log) {
  report::results out;
  log.report("test", out);
  return out;
}

TEST(NoiseLog, BlocksOneAfterAnotherAreAllBlocks) {
  const auto paper = bind_scene(load_scene("paper"));
  noise_log apart(*paper.model, blocks), in_turn(*paper.model, 0);
  over_blocks(*paper.model, [&](int block, int first_step, const increment_view& v) {
    apart.add(block, v, dt);
    in_turn.add_in_turn(first_step, v, dt);
  });
  const auto one = report_of(apart), other = report_of(in_turn);
  ASSERT_EQ(one.verdicts.size(), 1u);
  ASSERT_EQ(other.verdicts.size(), 1u);
  EXPECT_EQ(one.verdicts[0].kind, report::verdict_kind::holds);
  EXPECT_EQ(one.verdicts[0].reason, other.verdicts[0].reason);
  EXPECT_EQ(one.measurements[0].value, other.measurements[0].value);
  EXPECT_EQ(one.measurements[0].observable, other.measurements[0].observable);
}

// Every path starts alike, so that what is said of first steps is far from its law: a block's are those of its step 0.
TEST(NoiseLog, OneAfterAnotherAreBegunByTheirFirstStep) {
  const auto paper = bind_scene(load_scene("paper"));
  constexpr int many = 24;
  noise_log apart(*paper.model, many), in_turn(*paper.model, 0);
  increment_buffer buffer(*paper.model, steps, true, {});
  for (int block = 0; block < many; ++block)
    for (int piece = 0; piece < pieces; ++piece) {
      const auto v = buffer.fill(7, 0, static_cast<std::uint64_t>(piece * steps), steps, dt);
      apart.add(block, v, dt);
      in_turn.add_in_turn(piece * steps, v, dt);
    }
  const auto one = report_of(apart), other = report_of(in_turn);
  ASSERT_EQ(one.measurements.size(), 1u);
  EXPECT_EQ(one.measurements[0].observable, "one block times another");
  EXPECT_EQ(one.verdicts[0].reason, other.verdicts[0].reason);
  EXPECT_EQ(one.measurements[0].value, other.measurements[0].value);
}

TEST(NoiseLog, TheVerdictNamesTheLargestOfAllDeviationsAndWhatWouldBeSeen) {
  const auto paper = bind_scene(load_scene("paper"));
  const auto layout = paper.model->layout();
  noise_log log(*paper.model, blocks, {{"", 0}, {"less", 0}});
  std::vector<noise_audit> audits(blocks, noise_audit(layout.active, layout.active_pairs()));
  over_blocks(*paper.model, [&](int block, int, const increment_view& v) {
    log.add(block, v, dt);
    if (block == 0) log.add(block, v, dt, 1);
    audits[static_cast<std::size_t>(block)].add(
        {v.steps, layout.channels, layout.pairs(), v.dw, v.singles, v.area, dt});
  });
  auto sum = audits[0];
  for (std::size_t b = 1; b < blocks; ++b) sum.merge(audits[b]);
  const auto all = sum.deviations(), less = audits[0].deviations();
  EXPECT_TRUE(std::ranges::any_of(all, [](const auto& d) { return d.what == "variance of area 12"; }));
  noise_deviation most = all.front();
  for (const auto& d : all)
    if (std::fabs(d.z) > std::fabs(most.z)) most = d;
  for (const auto& d : less)
    if (std::fabs(d.z) > std::fabs(most.z)) most = {"less: " + d.what, d.z};
  const double limit = audit_threshold(all.size() + less.size());
  const auto v = report_of(log).verdicts.at(0);
  EXPECT_EQ(v.expected, 0.0);
  EXPECT_DOUBLE_EQ(*v.estimate, most.z);
  EXPECT_EQ(
      v.reason,
      fmt::format("{} moments and correlations, {:.1e} increments a channel: the largest is the {}, {:.1f} standard "
                  "errors from its law, at most {:.1f}; increments off by a factor of {:.5f} would be seen",
                  all.size() + less.size(), sum.increments(), most.what, most.z, limit,
                  1 + limit / std::sqrt(2 * sum.increments())));
}

TEST(NoiseLog, ADefectInOneOfItsPartsIsNamedAndRefuted) {
  const auto paper = bind_scene(load_scene("paper"));
  noise_log log(*paper.model, blocks, {{"healthy", 0}, {"loud", 0}});
  const auto late = log.open({"late", 0}, blocks);
  std::vector<double> louder;
  over_blocks(*paper.model, [&](int block, int, const increment_view& v) {
    log.add(block, v, dt, 0);
    log.add(block, v, dt, late);
    louder.assign(v.dw.begin(), v.dw.end());
    for (double& x : louder) x *= 1.1;
    auto loud = v;
    loud.dw = louder;
    log.add(block, loud, dt, 1);
  });
  const auto found = report_of(log);
  ASSERT_EQ(found.verdicts.size(), 1u);
  EXPECT_EQ(found.verdicts[0].kind, report::verdict_kind::refuted);
  EXPECT_NE(found.verdicts[0].reason.find("loud: variance"), std::string::npos) << found.verdicts[0].reason;
  ASSERT_EQ(found.measurements.size(), 3u);
  EXPECT_TRUE(found.measurements[1].observable.starts_with("loud: variance"));
}

TEST(NoiseLog, NothingHeardIsNoVerdict) {
  const auto paper = bind_scene(load_scene("paper"));
  const auto found = report_of(noise_log(*paper.model, 2));
  EXPECT_TRUE(found.verdicts.empty());
  EXPECT_TRUE(found.measurements.empty());
}

/// The first blocks, with areas up to some of them.
void hear(noise_log& log, const model& m, std::size_t part, int until, int with_areas_until) {
  over_blocks(m, [&](int block, int, const increment_view& v) {
    auto heard = v;
    if (block >= with_areas_until) heard.area = {};
    if (block < until) log.add(block, heard, dt, part);
  });
}

struct as_said {
  std::vector<std::pair<std::string, double>> measured;
  std::vector<std::string> reasons;
  explicit as_said(const report::results& r) {
    for (const auto& m : r.measurements) measured.emplace_back(m.observable, *m.value);
    for (const auto& v : r.verdicts) reasons.push_back(v.reason);
  }
  bool operator==(const as_said&) const = default;
};

// One process whose schemes need areas for two blocks, one whose schemes need increments for four, and none the
// other's.
TEST(NoiseLog, RunsOfSomeSchemesEachSayTogetherWhatARunOfAllSays) {
  const auto paper = bind_scene(load_scene("paper"));
  const std::vector<noise_log::part> parts{{"", 0}, {"finest", 0}};
  noise_log all(*paper.model, blocks, parts), with_areas(*paper.model, blocks, parts), far(*paper.model, blocks, parts);
  hear(all, *paper.model, 0, 4, 2);
  hear(all, *paper.model, 1, 1, 1);
  hear(with_areas, *paper.model, 0, 2, 2);
  hear(far, *paper.model, 0, 4, 0);
  hear(far, *paper.model, 1, 1, 1);
  for (const bool swapped : {false, true}) {
    std::vector runs{report_of(with_areas), report_of(far)};
    if (swapped) std::swap(runs[0], runs[1]);
    EXPECT_FALSE(as_said(runs[0]) == as_said(report_of(all)));
    const auto audits = as_of_one_run(runs, paper.schemes);
    for (auto& run : runs) {
      run.audits = audits;
      report_noise("test", run);
      EXPECT_TRUE(as_said(run) == as_said(report_of(all)));
    }
  }
}

TEST(NoiseLog, WhereSchemesDrawTheirOwnTheSameOneIsHeardWhoeverRunsIt) {
  const auto paper = bind_scene(load_scene("paper"));
  const auto told_of = [&](const std::vector<scheme_entry>& schemes, int until) {
    noise_log log(*paper.model, blocks);
    hear(log, *paper.model, 0, until, until);
    report::results out;
    log.report("test", out, heard_among(schemes).info.name);
    return out;
  };
  const auto of_all = told_of(paper.schemes, 2);
  const auto& heard = heard_among(paper.schemes);
  EXPECT_TRUE(heard.info.casimir.exact && heard.needs_areas) << heard.info.name;
  std::vector<scheme_entry> others;
  for (const auto& scheme : paper.schemes)
    if (scheme.info.name != heard.info.name) others.push_back(scheme);
  for (const bool swapped : {false, true}) {
    std::vector runs{told_of({heard}, 2), told_of(others, 4)};  // which hears more, of its own
    if (swapped) std::swap(runs[0], runs[1]);
    runs[0].audits = as_of_one_run(runs, paper.schemes);
    report_noise("test", runs[0]);
    EXPECT_TRUE(as_said(runs[0]) == as_said(of_all));
  }
}

TEST(NoiseLog, WhatIsSaidAnewStandsWhereItStood) {
  const auto paper = bind_scene(load_scene("paper"));
  noise_log log(*paper.model, blocks);
  hear(log, *paper.model, 0, 4, 4);
  report::results out;
  const auto other = [&](const char* scheme) {
    out.measurements.push_back({.experiment = "test", .scheme = scheme, .quantity = "largest deviation"});
    out.verdicts.push_back({.experiment = "test", .scheme = scheme, .claim = noise_claim});
  };
  other("heun");
  log.report("test", out);
  other("strang");
  const auto schemes = [&] {
    std::vector<std::string> names;
    for (const auto& m : out.measurements) names.push_back(m.scheme);
    for (const auto& v : out.verdicts) names.push_back(v.scheme);
    return names;
  };
  const auto before = schemes();
  report_noise("test", out);
  EXPECT_EQ(schemes(), before);
  EXPECT_EQ(before, (std::vector<std::string>{"heun", "noise", "strang", "heun", "noise", "strang"}));
}

/// The increments of one lane alone, [step][row].
struct path_increments {
  std::vector<double> dw, area;
  path_increments(const increment_view& v, const noise_layout& layout, int lane) {
    const auto of = [&](std::span<const double> all, int rows, std::vector<double>& out) {
      for (int i = 0; i < v.steps * rows; ++i) out.push_back(all[static_cast<std::size_t>(i * block_lanes + lane)]);
    };
    of(v.dw, layout.channels, dw);
    of(v.area, layout.pairs(), area);
  }
};

TEST(NoiseLog, PathsAreHeardOneByOneOrAloneAndJoined) {
  const auto paper = bind_scene(load_scene("paper"));
  const auto layout = paper.model->layout();
  noise_log at_once(*paper.model, blocks), joined(*paper.model, blocks);
  std::vector<noise_audit> audits(blocks, noise_audit(layout.active, layout.active_pairs()));
  over_blocks(*paper.model, [&](int block, int first_step, const increment_view& v) {
    if (first_step > 0) return;
    for (int lane = 0; lane < block_lanes; ++lane) {
      const path_increments one(v, layout, lane);
      auto path = v;
      path.dw = one.dw, path.area = one.area;
      const int number = block * block_lanes + lane;
      at_once.add_path(number, path, dt);
      joined.join(number, joined.alone(number, path, dt, 0), 0);
      audits[static_cast<std::size_t>(block)].add_path(
          {v.steps, layout.channels, layout.pairs(), one.dw, {}, one.area, dt}, lane);
    }
  });
  auto sum = audits[0];
  for (std::size_t b = 1; b < blocks; ++b) sum.merge(audits[b]);
  const auto expected = sum.deviations();
  const auto most = std::ranges::max_element(expected, {}, [](const auto& d) { return std::fabs(d.z); });
  for (const auto* log : {&at_once, &joined}) {
    const auto found = report_of(*log);
    ASSERT_EQ(found.measurements.size(), 1u);
    EXPECT_EQ(found.measurements[0].observable, most->what);
    EXPECT_NEAR(*found.measurements[0].value, most->z, 1e-12);
  }
}

TEST(NoiseLog, HearsTheOneThatKeepsTheOrbitThenTheOneWithAreas) {
  const auto scheme = [](const char* name, bool exact, bool areas) {
    scheme_entry e{};
    e.info.name = name;
    e.info.casimir.exact = exact;
    e.needs_areas = areas;
    return e;
  };
  const auto plain = scheme("plain", false, false), areas = scheme("areas", false, true),
             exact = scheme("exact", true, false), both = scheme("both", true, true);
  EXPECT_EQ(heard_among({plain, areas, exact, both}).info.name, "both");
  EXPECT_EQ(heard_among({plain, areas, exact}).info.name, "exact");
  EXPECT_EQ(heard_among({plain, areas}).info.name, "areas");
  EXPECT_EQ(heard_among({plain}).info.name, "plain");
}

}  // namespace
}  // namespace polhode
