// SPDX-License-Identifier: Apache-2.0
// What to_json writes, from_json reads back, number for number; what it did not write, it refuses on one line.
#include <gtest/gtest.h>

#include <bit>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>

#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"
#include "reports/writers/json.hpp"
#include "tests/golden/random_results.hpp"
#include "tests/golden/sample.hpp"

namespace polhode::golden {
namespace {

using report::from_json;
using report::to_json;

// Bit for bit, so that -0.0 counts.
bool same(std::optional<double> a, std::optional<double> b) {
  return a.has_value() == b.has_value() && (!a || std::bit_cast<std::uint64_t>(*a) == std::bit_cast<std::uint64_t>(*b));
}

TEST(round_trip, random_results_come_back_bit_for_bit) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    const auto before = random_results(seed).made();
    const auto after = from_json(to_json(before));
    ASSERT_EQ(to_json(after), to_json(before)) << seed;
    EXPECT_EQ(after.provenance.seed, before.provenance.seed);
    EXPECT_EQ(after.scene.name, before.scene.name);
    for (std::size_t i = 0; i < before.measurements.size(); ++i) {
      const auto &a = after.measurements[i], &b = before.measurements[i];
      EXPECT_TRUE(same(a.value, b.value) && same(a.low, b.low) && same(a.high, b.high) && a.at == b.at &&
                  a.over == b.over);
      EXPECT_TRUE(a.scheme == b.scheme && a.status == b.status && a.used == b.used && a.observable == b.observable);
      EXPECT_TRUE(same(after.fits[i].prefactor, before.fits[i].prefactor) &&
                  after.verdicts[i].kind == before.verdicts[i].kind);
      EXPECT_EQ(after.skipped[i].saved.work, before.skipped[i].saved.work);
      EXPECT_EQ(after.savings[i].what, before.savings[i].what);
      EXPECT_EQ(after.savings[i].saved.work, before.savings[i].saved.work);
      EXPECT_EQ(after.reused[i].computed, before.reused[i].computed);
      EXPECT_EQ(after.densities[i].values, before.densities[i].values);
      EXPECT_TRUE(same(after.densities[i].time, before.densities[i].time));
      EXPECT_TRUE(same(after.reused[i].saved.cpu_seconds, before.reused[i].saved.cpu_seconds));
    }
    EXPECT_EQ(after.done.work, before.done.work);
    EXPECT_EQ(after.done.results_reused, before.done.results_reused);
  }
}

TEST(round_trip, what_is_not_finite_is_null_with_a_status) {
  const auto text = to_json(sample());
  EXPECT_EQ(text.find("NaN"), std::string::npos);
  EXPECT_EQ(text.find(":nan"), std::string::npos);
  EXPECT_EQ(text.find("Infinity"), std::string::npos);
  const auto after = from_json(text);
  EXPECT_EQ(to_json(after), text) << "a second writing changes nothing";
  int unfinished = 0;
  for (const auto& m : after.measurements) {
    if (m.value && m.low.has_value() == m.high.has_value() && m.status == "ok") continue;
    EXPECT_NE(m.status, "ok");
    ++unfinished;
  }
  EXPECT_EQ(unfinished, 7);  // four of them numbers that carry a remark
}

std::string golden_text(const char* name) {
  std::ifstream file(std::string(POLHODE_GOLDEN_DATA) + "/" + name);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Units of coordinates, and what a verdict rests on, came with version 2.
TEST(round_trip, a_document_of_version_1_says_the_same) {
  auto expected = sample();
  for (auto& m : expected.measurements)
    for (auto& c : m.at) c.unit = c.name == report::step_size ? "time" : "";
  for (auto& v : expected.verdicts) v.evidence.clear();
  EXPECT_EQ(to_json(from_json(golden_text("results_1.json"))), to_json(from_json(to_json(expected))));
}

// Documents of the same schema that were written before these keys were.
TEST(round_trip, keys_that_came_later_may_be_missing) {
  auto older = sample();
  older.savings.clear();
  older.reused.clear();
  older.done = {};
  auto text = to_json(older);
  const auto expected = text;
  text.erase(text.find(",\n\"savings\""), std::string::npos);
  const std::string of_skips = R"(,"saved":{"normals_drawn":0,"path_steps":0,"kernels_run":0,"cpu_seconds":0.0})";
  for (auto at = text.find(of_skips); at != text.npos; at = text.find(of_skips)) text.erase(at, of_skips.size());
  EXPECT_EQ(to_json(from_json(text + "}")), expected);
}

void expect_refused(const std::string& text) {
  try {
    from_json(text);
    ADD_FAILURE() << "taken: " << text.substr(0, 60);
  } catch (const input_error& error) {
    EXPECT_TRUE(is_plain_text(error.what())) << error.what();
  }
}

TEST(round_trip, truncated_text_is_refused) {
  const auto text = to_json(sample());
  for (std::size_t length = 0; length + 2 < text.size(); length += 13) expect_refused(text.substr(0, length));
}

TEST(round_trip, foreign_text_is_refused) {
  for (const char* text :
       {"", "null", "[]", "{}", "1", "\xff", "{\"schema\":1}", "{\"schema\":{\"name\":\"other\\n\",\"version\":1}}",
        "{\"schema\":{\"name\":\"polhode-results\",\"version\":1}}",
        "{\"schema\":{\"name\":\"polhode-results\",\"version\":1e999}}"})
    expect_refused(text);
  const auto changed = [](const std::string& from, const std::string& to) {
    auto text = to_json(sample());
    return text.replace(text.find(from), from.size(), to);
  };
  expect_refused(changed("\"version\":2}", "\"version\":99}"));
  expect_refused(changed("\"threads\":2", "\"threads\":-2.5"));
  expect_refused(changed("\"threads\":2", "\"threads\":4294967296"));
  expect_refused(changed("\"verdict\":\"refuted\"", "\"verdict\":\"fine\""));
  expect_refused(changed("\"inertia\":[1.0,2.0,3.0]", "\"inertia\":[1.0,[2.0]]"));
  expect_refused(changed("\"theta\":0.5", "\"theta\":\"a lot\""));
  expect_refused(changed("\"theta\":0.5", "\"theta\":null"));
  expect_refused(changed("\"theta\":0.5", "\"the\x7fta\":{}"));
  expect_refused(changed("\"used\":false", "\"used\":0"));
  expect_refused(changed("\"results_reused\":3", "\"results_reused\":-3"));
  auto with_density = sample();
  with_density.densities.push_back({"attractor", "", "law", {}, 2, 2, {1, 1, 1}});
  expect_refused(to_json(with_density));
}

}  // namespace
}  // namespace polhode::golden
