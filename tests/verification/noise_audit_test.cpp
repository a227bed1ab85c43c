// SPDX-License-Identifier: Apache-2.0
// Broken noise is found by the audit of the run that it drives, and healthy noise is not.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <polhode/noise/normal.hpp>
#include <tuple>

#include "experiments/common/noise_verdict.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "statistics/control_variates.hpp"
#include "support/noise_defects.hpp"

namespace polhode {
namespace {

report::verdict audited(const std::string& experiment, const std::string& scheme, std::uint64_t seed = 1) {
  const auto r = verify(load_scene("paper"), {{scheme}, {experiment}, effort::quick, 2, seed});
  for (const auto& v : r.verdicts)
    if (v.scheme == noise_name && v.claim == noise_claim) return v;
  ADD_FAILURE() << experiment << " has no verdict on its noise";
  return {};
}

struct planted_noise {
  const char* what;
  std::function<std::unique_ptr<noise_defect>()> make;
  friend void PrintTo(const planted_noise& p, std::ostream* out) { *out << p.what; }
};

template <class Defect, class... Parameter>
planted_noise plant(const char* what, Parameter... p) {
  return {what, [=] { return std::make_unique<Defect>(p...); }};
}

using namespace test;
using namespace std::string_literals;
const planted_noise defects[] = {plant<increments_times>("increments x 1.02", 1.02),
                                 plant<increments_times>("increments x 1.002", 1.002),
                                 plant<channels_correlated>("channel 2 is channel 1", 1.0),
                                 plant<channels_correlated>("correlation 0.3", 0.3),
                                 plant<channels_correlated>("correlation 0.01", 0.01),
                                 plant<lanes_repeated>("lanes repeated"),
                                 plant<blocks_repeated>("blocks repeated"),
                                 plant<steps_reused>("steps reused"),
                                 plant<tail_clipped>("clipped at 4 sigma", 4.0),
                                 plant<area_variance_times>("area variance x 1.1", 1.1)};

struct BrokenNoise : testing::TestWithParam<planted_noise> {};

TEST_P(BrokenNoise, IsRefutedByTheAudit) {
  const auto defect = GetParam().make();
  const planted_noise_defect in_force(*defect);
  for (const char* experiment : {"strong", "gibbs"}) {
    const auto v = audited(experiment, "magnus");
    EXPECT_EQ(v.kind, report::verdict_kind::refuted) << experiment << ": " << v.reason;
    std::printf("%-24s | %-8s | %s\n", GetParam().what, experiment, v.reason.c_str());
  }
}
INSTANTIATE_TEST_SUITE_P(Planted, BrokenNoise, testing::ValuesIn(defects));

// Common to many bodies, where lanes are bodies and what repeats is paths; and in runs that end when paths break.
const planted_noise common_defects[] = {plant<increments_times>("variance x 1.02", std::sqrt(1.02)),
                                        plant<lanes_repeated>("paths repeated")};

struct BrokenNoiseOfLongRuns : testing::TestWithParam<std::tuple<planted_noise, std::string>> {};

TEST_P(BrokenNoiseOfLongRuns, IsRefutedByTheAudit) {
  const auto& [what, experiment] = GetParam();
  const auto defect = what.make();
  const planted_noise_defect in_force(*defect);
  const auto v = audited(experiment, "lie_euler");
  EXPECT_EQ(v.kind, report::verdict_kind::refuted) << v.reason;
  std::printf("%-24s | %-9s | %s\n", what.what, experiment.c_str(), v.reason.c_str());
}
INSTANTIATE_TEST_SUITE_P(Planted, BrokenNoiseOfLongRuns,
                         testing::Combine(testing::ValuesIn(common_defects),
                                          testing::Values("attractor"s, "stability"s)));

TEST(HealthyNoise, HasItsLaw) {
  for (const std::uint64_t seed : {1, 2, 3})
    for (const char* experiment : {"strong", "gibbs"}) {
      const auto v = audited(experiment, "magnus", seed);
      EXPECT_EQ(v.kind, report::verdict_kind::holds) << experiment << ": " << v.reason;
      EXPECT_LT(std::abs(*v.estimate), 5) << v.reason;
    }
}

/// "area 13 times channel 3" is "area times own channel": digits go, and what they say is kept.
std::string kind_of(const std::string& what) {
  const auto channel = what.find("times channel ");
  const auto area = what.find("area ");
  std::string kind = what;
  if (channel != what.npos)
    kind =
        what.substr(area + 5, 2).find(what.back()) != what.npos ? "area times own channel" : "area times other channel";
  std::erase_if(kind, [](char c) { return c >= '0' && c <= '9'; });
  return kind;
}

/// An audit of blocks of healthy steps whose areas are made of cells.
noise_audit of_cells(int cells, int steps, std::uint64_t first_block, std::uint64_t blocks) {
  noise_audit audit(3, 3, cells);
  std::vector<double> dw(std::size_t(steps) * 3 * 64), area(dw.size());
  for (std::uint64_t block = first_block; block < first_block + blocks; ++block) {
    std::ranges::fill(dw, 0.0);
    std::ranges::fill(area, 0.0);
    for (std::uint64_t i = 0; i < std::uint64_t(steps); ++i)
      for (std::uint64_t lane = 0; lane < 64; ++lane)
        for (int cell = 0; cell < cells; ++cell) {
          const auto z = normals<3>({7, noise_kind::increment, 64 * block + lane,
                                     i * static_cast<std::uint64_t>(cells) + static_cast<std::uint64_t>(cell)});
          const auto at = [&](std::vector<double>& v, int k) -> double& {
            return v[(i * 3 + static_cast<std::uint64_t>(k)) * 64 + lane];
          };
          int pair = 0;
          for (int j = 0; j < 3; ++j)
            for (int k = j + 1; k < 3; ++k) at(area, pair++) += 0.5 * (at(dw, j) * z[k] - z[j] * at(dw, k));
          for (int k = 0; k < 3; ++k) at(dw, k) += z[k];
        }
    noise_audit one(3, 3, cells);
    one.add({steps, 3, 3, dw, {}, area, static_cast<double>(cells)});
    audit.merge(one);
  }
  return audit;
}

// The audit's own law of areas made of cells: against areas made of cells.
TEST(HealthyNoise, AuditKnowsTheLawOfAreas) {
  for (const int cells : {2, 5, 32}) {
    const auto found = of_cells(cells, 16, 0, 60).deviations();
    ASSERT_FALSE(found.empty());
    for (const auto& d : found) EXPECT_LT(std::abs(d.z), 4.5) << cells << " cells: " << d.what;
  }
}

// One deviate is small whatever variance is put in the law; the squares of many have mean 1 under the right one alone.
TEST(HealthyNoise, DeviatesOfAreasHaveVarianceOne) {
  constexpr std::uint64_t audits = 64, blocks = 128;  // of two steps: as many numbers as squares need to be told
  for (const int cells : {2, 5}) {
    std::map<std::string, std::vector<double>> squares;  // by kind: which channels does not matter, but shared or not
    for (std::uint64_t a = 0; a < audits; ++a)
      for (const auto& d : of_cells(cells, 2, a * blocks, blocks).deviations())
        if (d.what.find("area") != std::string::npos) squares[kind_of(d.what)].push_back(d.z * d.z);
    EXPECT_EQ(squares.size(), 5);  // mean, variance, own channel, other channel, area times area: all three share one
    for (const auto& [kind, values] : squares) {
      const double count = static_cast<double>(values.size());
      const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
      EXPECT_NEAR(mean, 1, 5 * std::sqrt(2 / count)) << cells << " cells: " << kind;
    }
  }
}

TEST(Controls, AreSeenToHaveAMean) {
  Eigen::MatrixXd y(512, 3);
  for (int i = 0; i < 512; ++i) {
    const auto z = normals<2>({5, noise_kind::increment, static_cast<std::uint64_t>(i), 0});
    y.row(i) << z[0], 0, z[1] + 0.4;
  }
  EXPECT_LT(std::abs(means_of_controls(y.leftCols(2)).largest), 4);
  EXPECT_EQ(means_of_controls(y).count, 2);
  EXPECT_GT(means_of_controls(y).largest, audit_threshold(2));
}

}  // namespace
}  // namespace polhode
