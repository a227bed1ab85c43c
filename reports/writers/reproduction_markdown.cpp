// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/reproduction_markdown.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "reports/writers/markdown.hpp"
#include "reports/writers/reproduction_numbers.hpp"
#include "reports/writers/text.hpp"

namespace polhode::report {
namespace {

std::string verdict_of(const reproduced_number& n) {
  const auto off = shown_difference(n);
  return fmt::format("{}{}", name_of(n.verdict), off.empty() ? "" : " " + off);
}

void append_reproduction(std::string& out, const reproduction& r) {
  out += fmt::format("## {}\n\n{}: {}.\n\nSource: {}.\n\n", escape_markdown(r.name), escape_markdown(r.title),
                     sentence(r), escape_markdown(r.source));
  append_table_head(out, {"quantity", "published", "ours", "verdict", "why"});
  for (const auto& n : r.numbers)
    append_table_row(
        out, {escape_markdown(n.quantity), shown_published(n), shown_ours(n), verdict_of(n), escape_markdown(n.why)});
  out += '\n';
  for (const auto& note : r.notes) out += fmt::format("- {}\n", escape_markdown(note));
  if (!r.notes.empty()) out += '\n';
  if (!r.scene.empty()) out += fmt::format("```toml\n{}```\n\n", r.scene);
}

}  // namespace

std::string to_markdown(std::span<const reproduction> all) {
  std::string out =
      "# Published figures, run again\n\nThis page is what `polhode reproduce --out DIR` writes. A number agrees where "
      "ours, with all of its interval, lies in what the published one allows.\n\n";
  append_table_head(out, {"case", "what was published", "verdict", "numbers"});
  for (const auto& r : all)
    append_table_row(
        out, {escape_markdown(r.name), escape_markdown(r.title), std::string(name_of(r.verdict())), sentence(r)});
  out += '\n';
  for (const auto& r : all) append_reproduction(out, r);
  while (out.ends_with("\n\n")) out.pop_back();
  return out;
}

}  // namespace polhode::report
