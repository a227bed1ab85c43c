// SPDX-License-Identifier: Apache-2.0
// What a system's table accepts, in which shape it keeps it, and what it refuses.
#include "problem/parameters.hpp"

#include <gtest/gtest.h>

#include "systems/systems.hpp"

namespace polhode {
namespace {

using report::number_rows;
using report::shape;
using answer = std::optional<number_rows>;

TEST(Parameters, Numbers) {
  const auto from = dissipation_strength("", "");
  EXPECT_EQ(from.read({{0}}, shape::number), (answer{{{0}}}));
  EXPECT_FALSE(from.read({{-1}}, shape::number));
  EXPECT_FALSE(from.read({{1}}, shape::vector));
}

TEST(Parameters, Vectors) {
  const auto any = vector_of("a", 3, "", ""), positive = positive_vector_of("a", 3, "", "");
  EXPECT_EQ(any.read({{1, -2, 0}}, shape::vector), (answer{{{1, -2, 0}}}));
  EXPECT_FALSE(any.read({{1, 2}}, shape::vector));
  EXPECT_FALSE(positive.read({{1, 2, 0}}, shape::vector));
  EXPECT_FALSE(positive.read({{1}}, shape::number));
  EXPECT_EQ(any.accepts, "three finite numbers");
}

TEST(Parameters, SymmetricMatrices) {
  const auto rule = symmetric_matrix("a", 2, "", "");
  EXPECT_EQ(rule.read({{1, -2}}, shape::vector), (answer{{{1, 0}, {0, -2}}}));
  EXPECT_EQ(rule.read({{1, 3}, {3, 2}}, shape::vectors), (answer{{{1, 3}, {3, 2}}}));
  EXPECT_FALSE(rule.read({{1, 3}, {4, 2}}, shape::vectors));
  EXPECT_FALSE(rule.read({{1, 3}}, shape::vectors));
  EXPECT_FALSE(rule.read({{1, 3}, {3}}, shape::vectors));
  EXPECT_FALSE(rule.read({{1}}, shape::number));
}

TEST(Parameters, NoiseVectors) {
  const auto rule = noise_vectors(2, "");
  EXPECT_EQ(rule.read({{0.5}}, shape::number), (answer{{{0.5, 0}, {0, 0.5}}}));
  EXPECT_EQ(rule.read({{0.5, 0}}, shape::vector), (answer{{{0.5, 0}}}));
  EXPECT_EQ(rule.read({}, shape::vectors), answer{number_rows{}});
  EXPECT_EQ(rule.read({{1, 1}, {0, 0}, {0, 2}}, shape::vectors), (answer{{{1, 1}, {0, 2}}}));
  EXPECT_FALSE(rule.read({{1, 1}, {1}}, shape::vectors));
  EXPECT_FALSE(rule.read({{1, 2, 3}}, shape::vector));
}

TEST(Parameters, WordsAreNoNumbers) {
  const auto rule = one_of("noise", {"field", "field and damping"}, "");
  EXPECT_EQ(rule.shape, shape::word);
  EXPECT_EQ(rule.accepts, "\"field\" or \"field and damping\"");
  EXPECT_FALSE(rule.read({{1}}, shape::number));
}

// The parser, JSON, the page and `list systems` show what stands there.
TEST(Parameters, EverySystemStatesItsOwnInFull) {
  ASSERT_FALSE(systems().empty());
  for (const auto& s : systems()) {
    EXPECT_EQ(find_system(s.name), &s);
    ASSERT_FALSE(s.parameters.empty()) << s.name;
    for (const auto& p : s.parameters) {
      EXPECT_FALSE(p.meaning.empty()) << s.name << ' ' << p.name;
      EXPECT_FALSE(p.accepts.empty()) << s.name << ' ' << p.name;
      EXPECT_TRUE(p.read) << s.name << ' ' << p.name;
      for (const auto* taken : {"name", "system", "momentum", "horizon", "steps"}) EXPECT_NE(p.name, taken) << s.name;
    }
  }
  EXPECT_EQ(find_system("rigid"), nullptr);
}

}  // namespace
}  // namespace polhode
