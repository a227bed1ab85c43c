// The page is the template with two places filled: nothing else changes, and no text of the results acts as markup.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

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
  std::string title, json;
};

// What stands in the two places, after all around them was found unchanged.
parts parts_of(const std::string& page) {
  const auto all = whole_template();
  const auto title = all.find(report::title_place), data = all.find(report::results_place);
  const auto before = all.substr(0, title), after = all.substr(data + report::results_place.size());
  const auto between = all.substr(title + report::title_place.size(), data - title - report::title_place.size());
  EXPECT_EQ(page.substr(0, before.size()), before);
  EXPECT_EQ(page.substr(page.size() - after.size()), after);
  const auto middle = page.find(between, before.size());
  EXPECT_NE(middle, std::string::npos);
  const auto begin = middle + between.size();
  return {page.substr(before.size(), middle - before.size()), page.substr(begin, page.size() - after.size() - begin)};
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
}

TEST(page, hostile_text_stays_text) {
  const auto found = parts_of(report::to_html(sample()));
  EXPECT_EQ(found.title, "&lt;/script&gt;&lt;img src=x onerror=alert(1)&gt; · polhode");
  EXPECT_EQ(found.json.find('<'), std::string::npos);
  EXPECT_EQ(without_escapes(found.json), report::to_json(sample()));
}

TEST(page, a_name_that_looks_like_a_place_stays_a_name) {
  for (const auto place : {report::title_place, report::results_place}) {
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
