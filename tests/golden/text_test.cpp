// SPDX-License-Identifier: Apache-2.0
// Text from outside, made harmless for each format; folder names.
#include <gtest/gtest.h>

#include "reports/writers/folder.hpp"
#include "reports/writers/latex.hpp"
#include "reports/writers/numbers.hpp"
#include "reports/writers/text.hpp"

namespace polhode::report {
namespace {

TEST(text, what_is_not_utf8_is_replaced) {
  EXPECT_EQ(valid_utf8("aΠ€😀z"), "aΠ€😀z");
  EXPECT_EQ(valid_utf8("\xFF\xC0\x80"), "���");
  EXPECT_EQ(valid_utf8("\xED\xA0\x80"), "���") << "a surrogate";
  EXPECT_EQ(valid_utf8("\xE2\x82"), "��") << "cut short";
  EXPECT_EQ(printable(std::string_view("a\0b\x1B\n", 5)), "a�b�\n");
  EXPECT_EQ(printable("\xEF\xBF\xBE"), "�") << "a non-character";
}

TEST(text, marks_are_made_harmless) {
  EXPECT_EQ(escape_html("<a href=\"x\">&'</a>"), "&lt;a href=&quot;x&quot;&gt;&amp;&#39;&lt;/a&gt;");
  EXPECT_EQ(escape_markdown("a|b\n<c> lie_heun _x_ `d` [e]"), "a\\|b &lt;c&gt; lie_heun \\_x\\_ \\`d\\` \\[e\\]");
  EXPECT_EQ(escape_markdown("a\x1B\r\n b"), "a� b");
  EXPECT_EQ(escape_latex("a_b\n\tΠ€ \xFF 5 %"), "a\\_b $\\Pi$? ? 5 \\%");
  EXPECT_EQ(shortened("αβγδ", 3), "αβ…");
  EXPECT_EQ(shortened("αβγ", 3), "αβγ");
}

TEST(text, numbers_read_as_a_reader_expects) {
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(std::nullopt), "");
  EXPECT_EQ(shown(1.23456e-5), "1.235e-5");
  EXPECT_EQ(shown(1e100), "1e100");
  EXPECT_EQ(shown_interval(0.5, std::nullopt), "");
  EXPECT_EQ(shown_duration(83.25), "1 min 23 s");
}

TEST(text, names_read_as_a_reader_expects) {
  EXPECT_EQ(as_written("lambda_1 map"), "λ₁ map");
  EXPECT_EQ(as_written("sigma_of_theta"), "σ of θ");
  EXPECT_EQ(as_written("energy"), "energy");
}

TEST(text, a_folder_name_stays_inside_its_folder_and_apart_from_others) {
  EXPECT_EQ(folder_name("paper"), "paper");
  EXPECT_EQ(folder_name("heavy_top-2.5"), "heavy_top-2.5");
  for (const char* name :
       {"", ".", "..", "../../etc/passwd", "/", ".hidden", "-rf", "a\nb", "</script><img onerror=…>"}) {
    const auto folder = folder_name(name);
    EXPECT_EQ(folder.find('/'), std::string::npos) << name;
    EXPECT_NE(folder.front(), '.') << name;
    EXPECT_NE(folder.front(), '-') << name;
    EXPECT_LT(folder.size(), 120u) << name;
  }
  EXPECT_NE(folder_name("a b"), folder_name("a/b"));
  EXPECT_LT(folder_name(std::string(5000, 'x')).size(), 120u);
}

}  // namespace
}  // namespace polhode::report
