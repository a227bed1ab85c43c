// SPDX-License-Identifier: Apache-2.0
// How processes share schemes: each computed once, loads alike, whole experiments where there are enough of them.
#include "run/shared_work.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace {

using namespace polhode;

double load_of(const std::map<std::string, dealt_schemes>& dealt, std::span<const scheme_cost> costs,
               std::size_t rank) {
  double load = 0;
  for (const auto& one : costs)
    if (std::ranges::find(dealt.at(one.experiment)[rank], one.scheme) != dealt.at(one.experiment)[rank].end())
      load += one.cpu_seconds;
  return load;
}

std::size_t sharers(const dealt_schemes& dealt) {
  return static_cast<std::size_t>(std::ranges::count_if(dealt, [](const auto& some) { return !some.empty(); }));
}

TEST(SharedWork, EachSchemeIsDealtOnce) {
  const std::vector<scheme_cost> costs{{"weak", "heun", 3},    {"weak", "milstein", 2},   {"weak", "strang", 9},
                                       {"gibbs", "strang", 5}, {"strong", "milstein", 1}, {"strong", "heun", 0}};
  for (int ranks = 1; ranks <= 9; ++ranks) {
    const auto dealt = deal(costs, ranks);
    ASSERT_EQ(dealt.size(), 3U);
    std::multiset<std::pair<std::string, std::string>> given, wanted;
    for (const auto& [experiment, by_rank] : dealt) {
      ASSERT_EQ(by_rank.size(), static_cast<std::size_t>(ranks));
      for (const auto& some : by_rank)
        for (const auto& scheme : some) given.emplace(experiment, scheme);
    }
    for (const auto& one : costs) wanted.emplace(one.experiment, one.scheme);
    EXPECT_EQ(given, wanted);
  }
}

TEST(SharedWork, AnExperimentStaysWholeWhereOthersFillTheRest) {
  const std::vector<scheme_cost> costs{
      {"weak", "heun", 4}, {"weak", "strang", 4}, {"gibbs", "heun", 5}, {"energy", "heun", 3}};
  const auto dealt = deal(costs, 2);
  for (const auto& [experiment, by_rank] : dealt) EXPECT_EQ(sharers(by_rank), 1U) << experiment;
  EXPECT_EQ(load_of(dealt, costs, 0), 8);
  EXPECT_EQ(load_of(dealt, costs, 1), 8);
}

TEST(SharedWork, AnExperimentThatIsMoreThanAShareIsSplit) {
  const std::vector<scheme_cost> costs{
      {"weak", "heun", 40}, {"weak", "strang", 30}, {"weak", "milstein", 9}, {"gibbs", "heun", 2}};
  const auto dealt = deal(costs, 2);
  EXPECT_EQ(sharers(dealt.at("weak")), 2U);
  EXPECT_EQ(sharers(dealt.at("gibbs")), 1U);
  EXPECT_EQ(load_of(dealt, costs, 0) + load_of(dealt, costs, 1), 81);
  EXPECT_LE(std::max(load_of(dealt, costs, 0), load_of(dealt, costs, 1)), 43);
}

TEST(SharedWork, ThereAreNoMoreSharersThanSchemes) {
  const std::vector<scheme_cost> costs{{"weak", "heun", 40}, {"weak", "strang", 30}};
  EXPECT_EQ(sharers(deal(costs, 5).at("weak")), 2U);
}

TEST(SharedWork, NothingToDoIsDealtToNobody) { EXPECT_TRUE(deal({}, 3).empty()); }

}  // namespace
