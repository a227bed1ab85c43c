// SPDX-License-Identifier: Apache-2.0
// The nearest name, and text made fit for one line.
#include "scene/nearest.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"

namespace {

using polhode::nearest_name;
const std::vector<std::string> names{"heun", "heun_projected", "lie_heun", "strang", "strang_weak2", "theta"};

TEST(nearest, finds_what_was_meant) {
  struct {
    std::string typed, meant;
  } const cases[] = {
      {"heun", "heun"},        {"huen", "heun"},         {"HEUN", "heun"},     {"hen", "heun"},
      {"lieheun", "lie_heun"}, {"lie-heun", "lie_heun"}, {"starng", "strang"}, {"strang_weak", "strang_weak2"},
      {"thta", "theta"},       {"Theta", "theta"}};
  for (const auto& c : cases) EXPECT_EQ(nearest_name(c.typed, names), c.meant) << c.typed;
}

TEST(nearest, is_silent_when_nothing_is_near) {
  for (const std::string far : {"", "x", "xy", "magnus", "inertia", "schema", "zzzzzzzzzzzzzzzzzzzzzzzzz"})
    EXPECT_EQ(nearest_name(far, names), "") << far;
  EXPECT_EQ(nearest_name("heun", {}), "");
}

TEST(nearest, a_swap_of_neighbours_is_one_edit) {
  EXPECT_EQ(nearest_name("ab", std::vector<std::string>{"ba"}), "ba");
  EXPECT_EQ(nearest_name("ab", std::vector<std::string>{"bc"}), "");
}

TEST(nearest, half_may_differ_and_no_more) {
  EXPECT_EQ(nearest_name("abcd", std::vector<std::string>{"abxy"}), "abxy");
  EXPECT_EQ(nearest_name("abcd", std::vector<std::string>{"axyz"}), "");
}

TEST(nearest, of_long_names_a_quarter_and_one_more_may_differ) {
  EXPECT_EQ(nearest_name("abcdefgh", std::vector<std::string>{"abcdexyz"}), "abcdexyz");
  EXPECT_EQ(nearest_name("abcdefgh", std::vector<std::string>{"abcdwxyz"}), "");
}

TEST(nearest, the_first_of_equals_is_taken) {
  EXPECT_EQ(nearest_name("abcx", std::vector<std::string>{"abcd", "abce"}), "abcd");
}

TEST(nearest, what_is_chosen_is_a_place_or_is_refused) {
  using polhode::choose;
  EXPECT_EQ(choose("--scheme", "lie_heun", names), 2U);
  const auto refusal = [](std::string_view value, const std::vector<std::string>& known) -> std::string {
    try {
      choose("--scheme", value, known);
    } catch (const polhode::input_error& fault) {
      return fault.what();
    }
    return "";
  };
  EXPECT_EQ(refusal("huen", {"heun", "strang"}),
            "--scheme 'huen': not known; did you mean 'heun'?; accepted: heun, strang");
  EXPECT_EQ(refusal("a\nb", {"heun", "strang"}), "--scheme 'a b': not known; accepted: heun, strang");
}

TEST(one_line, folds_and_escapes) {
  using polhode::one_line;
  EXPECT_EQ(one_line("  a\n\tb \r\n"), "a b");
  EXPECT_EQ(one_line("\x1b[31mred"), "\\x1b[31mred");
  EXPECT_EQ(one_line("\xc2\x9b"), "\\xc2\\x9b");
  EXPECT_EQ(one_line("caf\xc3\xa9 \xff"), "caf\xc3\xa9 \\xff");
  EXPECT_EQ(one_line(std::string(1, '\0')), "\\x00");
  EXPECT_EQ(one_line(""), "");
}

TEST(one_line, is_cut_between_characters) {
  using polhode::one_line;
  EXPECT_EQ(one_line("abcdef", 6), "abcdef");
  EXPECT_EQ(one_line("abcdefg", 6), "abcde…");
  EXPECT_EQ(one_line("ééééééé", 6), "ééééé…");
  EXPECT_EQ(one_line("日本語日本", 6), "日本…");
  EXPECT_LE(polhode::display_width(one_line("日本語日本", 6)), 6U);
}

TEST(plain_text, is_utf8_without_controls) {
  using polhode::is_plain_text;
  for (const std::string good : {"paper", "θ = ½", "日本語", "<b>&amp;", "a b"})
    EXPECT_TRUE(is_plain_text(good)) << good;
  // Overlong, surrogate, beyond Unicode, cut short, stray continuation, C1 control, right-to-left override.
  for (const std::string bad :
       {"a\nb", "\x7f", "\xc0\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xe2\x82", "\x80", "\xc2\x85", "\xe2\x80\xae"})
    EXPECT_FALSE(is_plain_text(bad)) << polhode::one_line(bad);
}

TEST(display_width, counts_columns) {
  EXPECT_EQ(polhode::display_width("abc"), 3U);
  EXPECT_EQ(polhode::display_width("é"), 1U);
  EXPECT_EQ(polhode::display_width("日本"), 4U);
  EXPECT_EQ(polhode::display_width("e\xcc\x81"), 1U);
}

}  // namespace
