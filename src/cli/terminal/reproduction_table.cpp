// SPDX-License-Identifier: Apache-2.0
#include "cli/terminal/reproduction_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "cli/terminal/layout.hpp"
#include "reports/model/text.hpp"
#include "reports/writers/reproduction_numbers.hpp"

namespace polhode::cli {
namespace {

constexpr std::size_t columns = 4, narrow_table = 72, number_width = 16, verdict_width = 9;
using cells = std::array<std::string, columns>;

std::vector<std::string> lines_of(const std::string& text, std::size_t width) {
  std::vector<std::string> out{""};
  for (const char c : wrapped(text, width))
    if (c == '\n')
      out.emplace_back();
    else
      out.back() += c;
  return out;
}

/// Side by side, each cell broken into its own lines.
std::string row_beside(const cells& row, const std::array<std::size_t, columns>& widths) {
  std::array<std::vector<std::string>, columns> lines;
  std::size_t tallest = 0;
  for (std::size_t k = 0; k < columns; ++k) {
    lines[k] = lines_of(row[k], widths[k]);
    tallest = std::max(tallest, lines[k].size());
  }
  std::string out;
  for (std::size_t i = 0; i < tallest; ++i) {
    std::string line;
    for (std::size_t k = 0; k < columns; ++k) {
      const auto piece = i < lines[k].size() ? lines[k][i] : "";
      const auto used = display_width(piece);
      line += piece + std::string(widths[k] > used ? widths[k] - used : 0, ' ') + (k + 1 < columns ? "  " : "");
    }
    line.erase(line.find_last_not_of(' ') + 1);
    out += line + '\n';
  }
  return out;
}

std::string verdict_of(const report::reproduced_number& n) {
  const auto off = report::shown_difference(n);
  const std::string word = n.verdict == report::agreement::agrees      ? "agrees"
                           : n.verdict == report::agreement::explained ? "explained"
                                                                       : "DIFFERS";
  return off.empty() ? word : word + ' ' + off;
}

std::string beside(const report::reproduction& r, std::size_t width) {
  const std::array<std::size_t, columns> widths{width - 2 * number_width - verdict_width - 6, number_width,
                                                number_width, verdict_width};
  auto out = row_beside({"quantity", "published", "ours", "verdict"}, widths);
  for (const auto& n : r.numbers)
    out += row_beside({n.quantity, report::shown_published(n), report::shown_ours(n), verdict_of(n)}, widths);
  return out;
}

/// Where there is no room for columns.
std::string below(const report::reproduction& r, std::size_t width) {
  std::string out;
  for (const auto& n : r.numbers) {
    out += wrapped(n.quantity, width) + '\n';
    out += "  " + wrapped("published " + report::shown_published(n), width, 4, 2) + '\n';
    out += "  " + wrapped("ours " + report::shown_ours(n), width, 4, 2) + '\n';
    out += "  " + wrapped(verdict_of(n), width, 4, 2) + '\n';
  }
  return out;
}

std::string reasons_of(const report::reproduction& r, std::size_t width) {
  std::string out;
  for (const auto& n : r.numbers)
    if (n.verdict != report::agreement::agrees)
      out += wrapped(fmt::format("{}: {}: {}", name_of(n.verdict), n.quantity, n.why), width, 2) + '\n';
  return out;
}

}  // namespace

std::string to_text(std::span<const report::reproduction> all, std::size_t width) {
  std::string out;
  for (const auto& r : all) {
    out += wrapped(fmt::format("{}: {}: {}", r.name, r.title, report::sentence(r)), width, 2) + '\n';
    out += wrapped("source: " + r.source, width, 2) + "\n\n";
    out += width < narrow_table ? below(r, width) : beside(r, width);
    if (const auto reasons = reasons_of(r, width); !reasons.empty()) out += '\n' + reasons;
    if (&r != &all.back()) out += '\n';
  }
  return out;
}

int exit_code(std::span<const report::reproduction> all) {
  const auto differs = [](const report::reproduction& r) { return r.verdict() == report::agreement::differs; };
  return std::ranges::any_of(all, differs) ? 1 : 0;
}

}  // namespace polhode::cli
