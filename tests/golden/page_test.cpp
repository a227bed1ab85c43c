// SPDX-License-Identifier: Apache-2.0
// The page is the template with its places filled: nothing else changes, and no text of the results acts as markup.
#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <boost/archive/iterators/binary_from_base64.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <span>
#include <string>
#include <string_view>

#include "reports/writers/comparison_json.hpp"
#include "reports/writers/html.hpp"
#include "reports/writers/json.hpp"
#include "reports/writers/packed.hpp"
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

// The text that was packed; it is known how long that was.
std::string unpacked(const std::string& base64, std::size_t size) {
  using namespace boost::archive::iterators;
  using bytes = transform_width<binary_from_base64<std::string::const_iterator>, 8, 6>;
  std::string digits = base64, text(size, '\0');
  const auto filling = static_cast<std::size_t>(std::ranges::count(digits, '='));
  std::ranges::replace(digits, '=', 'A');
  const std::string packed(bytes(digits.cbegin()), bytes(digits.cend()));
  uLongf length = size;
  EXPECT_EQ(::uncompress(reinterpret_cast<Bytef*>(text.data()), &length, reinterpret_cast<const Bytef*>(packed.data()),
                         packed.size() - filling),
            Z_OK);
  EXPECT_EQ(length, size);
  return text;
}

void expect_packed(const std::string& found, const std::string& text) { EXPECT_EQ(unpacked(found, text.size()), text); }

TEST(page, holds_results_json_and_the_name) {
  const auto found = parts_of(report::to_html(sample_named("plain")));
  EXPECT_EQ(found.title, "plain · polhode");
  expect_packed(found.json, report::to_json(sample_named("plain")));
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
  expect_packed(found.json, report::to_json(sample_named("plain")));
  expect_packed(found.before, report::to_json(drawn));
  expect_packed(found.comparison, report::to_json(std::span(&changes, 1)));
}

TEST(page, hostile_text_stays_text) {
  const auto found = parts_of(report::to_html(sample()));
  EXPECT_EQ(found.title, "&lt;/script&gt;&lt;img src=x onerror=alert(1)&gt; · polhode");
  expect_packed(found.json, report::to_json(sample()));
}

TEST(page, a_name_that_looks_like_a_place_stays_a_name) {
  for (const auto place :
       {report::title_place, report::results_place, report::before_place, report::comparison_place}) {
    const std::string name(place);
    const auto found = parts_of(report::to_html(sample_named(name.c_str())));
    EXPECT_EQ(found.title, name + " · polhode");
    expect_packed(found.json, report::to_json(sample_named(name.c_str())));
  }
}

TEST(page, what_it_carries_is_no_markup_and_short) {
  const auto text = report::to_json(sample());
  for (std::size_t length : {0, 1, 2, 3, 4, 1000}) {
    const auto found = report::packed(text.substr(0, length));
    EXPECT_EQ(found.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/="), found.npos);
    EXPECT_EQ(found.size() % 4, 0u);
    if (length > 0) expect_packed(found, text.substr(0, length));
  }
  EXPECT_EQ(report::packed(""), "");
  EXPECT_EQ(report::packed(text), report::packed(text));
  EXPECT_LT(report::packed(text).size(), text.size() / 4);
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
