// SPDX-License-Identifier: Apache-2.0
// The page is the template with its places filled: nothing else changes, and no text of the results acts as markup.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>

#include "reports/writers/comparison_json.hpp"
#include "reports/writers/html.hpp"
#include "reports/writers/json.hpp"
#include "reports/writers/page_template.hpp"
#include "tests/golden/sample.hpp"

namespace polhode::golden {
namespace {

std::string whole_template() {
  std::string page;
  for (const auto piece : report::page_template()) page += piece;
  return page;
}

struct parts {
  std::string title, json, before, comparison;
};

// What stands in the places, after all around them was found unchanged.
parts parts_of(const std::string& page) {
  constexpr std::array places{report::title_place, report::results_place, report::before_place,
                              report::comparison_place};
  const auto all = whole_template();
  std::array<std::string, places.size()> found;
  const auto first = all.find(places[0]);
  EXPECT_EQ(page.substr(0, first), all.substr(0, first));
  std::size_t in_template = first, in_page = first;
  for (std::size_t i = 0; i < places.size(); ++i) {
    in_template += places[i].size();
    const bool last = i + 1 == places.size();
    const auto next = last ? all.size() : all.find(places[i + 1]);
    const auto between = all.substr(in_template, next - in_template);
    const auto end = last ? page.size() - between.size() : page.find(between, in_page);
    EXPECT_EQ(page.substr(end, between.size()), between);
    found[i] = page.substr(in_page, end - in_page);
    in_page = end + between.size();
    in_template = next;
  }
  return {found[0], found[1], found[2], found[3]};
}

std::string without_escapes(std::string json) {
  constexpr std::string_view escaped = "\\u003c";
  for (auto at = json.find(escaped); at != json.npos; at = json.find(escaped, at + 1))
    json.replace(at, escaped.size(), "<");
  return json;
}

TEST(page, holds_results_json_and_the_name) {
  const auto found = parts_of(report::to_html(sample_named("plain")));
  EXPECT_EQ(found.title, "plain · polhode");
  EXPECT_EQ(without_escapes(found.json), report::to_json(sample_named("plain")));
  EXPECT_EQ(found.before + found.comparison, "");
}

TEST(page, holds_the_earlier_results_and_the_comparison) {
  report::comparison changes;
  changes.scene = "</script><script>";
  changes.changes.resize(1);
  auto before = sample();
  const auto drawn = before;
  before.densities.push_back({"attractor", "", "law", {}, 2, 2, {1, 1, 1, 1}});
  const auto found = parts_of(report::to_html(before, sample_named("plain"), changes));
  EXPECT_EQ(found.title, "plain · polhode");
  EXPECT_EQ((found.before + found.comparison).find('<'), std::string::npos);
  EXPECT_EQ(without_escapes(found.json), report::to_json(sample_named("plain")));
  EXPECT_EQ(without_escapes(found.before), report::to_json(drawn));
  EXPECT_EQ(without_escapes(found.comparison), report::to_json(std::span(&changes, 1)));
}

TEST(page, hostile_text_stays_text) {
  const auto found = parts_of(report::to_html(sample()));
  EXPECT_EQ(found.title, "&lt;/script&gt;&lt;img src=x onerror=alert(1)&gt; · polhode");
  EXPECT_EQ(found.json.find('<'), std::string::npos);
  EXPECT_EQ(without_escapes(found.json), report::to_json(sample()));
}

TEST(page, a_name_that_looks_like_a_place_stays_a_name) {
  for (const auto place :
       {report::title_place, report::results_place, report::before_place, report::comparison_place}) {
    const std::string name(place);
    const auto found = parts_of(report::to_html(sample_named(name.c_str())));
    EXPECT_EQ(found.title, name + " · polhode");
    EXPECT_EQ(without_escapes(found.json), report::to_json(sample_named(name.c_str())));
  }
}

TEST(page, template_is_small_and_asks_for_nothing) {
  const auto page = whole_template();
  EXPECT_LT(page.size(), 1'200'000u);
  EXPECT_TRUE(std::all_of(page.begin(), page.end(), [](unsigned char c) { return c < 0x80; }));
  for (const char* one : {"<link", "<img", "<iframe", " src=", "@import", "url(http", "url(//"})
    EXPECT_EQ(page.find(one), std::string::npos) << one;
}

}  // namespace
}  // namespace polhode::golden
