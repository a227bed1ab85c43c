// SPDX-License-Identifier: Apache-2.0
#include "reports/plots/titles.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "reports/model/finite.hpp"

namespace polhode::report {
namespace {

/// "distance to": what follows is no "of".
bool ends_open(std::string_view quantity) {
  constexpr std::array<std::string_view, 4> words{"from", "to", "at", "over"};
  const auto blank = quantity.find_last_of(" _");
  return blank != quantity.npos && std::ranges::find(words, quantity.substr(blank + 1)) != words.end();
}

std::string name_of(const measurement& m) {
  if (m.observable.empty()) return m.quantity;
  return ends_open(m.quantity) ? fmt::format("{} ({})", m.quantity, m.observable)
                               : fmt::format("{} of {}", m.quantity, m.observable);
}

std::string slug_of(const std::string& part) {
  std::string out;
  bool between = false;
  for (const char c : part) {
    const char low = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (!((low >= 'a' && low <= 'z') || (low >= '0' && low <= '9') || low == '.')) {
      between = true;
      continue;
    }
    if (between && !out.empty()) out += '-';
    between = false;
    out += low;
  }
  return out.empty() ? "x" : out;
}

}  // namespace

std::string with_unit(const std::string& text, const std::string& unit) {
  return unit.empty() || unit == "1" ? text : fmt::format("{} [{}]", text, unit);
}

std::string title_of(const measurement& m) { return with_unit(name_of(m), m.unit); }

std::string absolute_title_of(const measurement& m) { return with_unit(fmt::format("|{}|", name_of(m)), m.unit); }

std::string missing_in(const row_list& rows) {
  constexpr std::size_t most = 3;
  std::size_t missing = 0;
  std::vector<std::string> reasons;
  for (const auto* m : rows) {
    if (finite(m->value)) continue;
    ++missing;
    const auto reason = status_of(*m);
    if (reasons.size() < most && std::ranges::find(reasons, reason) == reasons.end()) reasons.push_back(reason);
  }
  if (missing == 0) return "";
  return fmt::format("{} value{} missing: {}.", missing, missing == 1 ? " is" : "s are", fmt::join(reasons, "; "));
}

std::string slug(std::initializer_list<std::string> parts) {
  std::vector<std::string> slugs;
  for (const auto& part : parts)
    if (!part.empty()) slugs.push_back(slug_of(part));
  return fmt::format("{}", fmt::join(slugs, "."));
}

}  // namespace polhode::report
