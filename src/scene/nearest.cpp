// SPDX-License-Identifier: Apache-2.0
#include "scene/nearest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"

namespace polhode {
namespace {

// ASCII only: names are ASCII, and std::tolower depends on the locale.
char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
bool same(char a, char b) { return lower(a) == lower(b); }

/// Insertions, deletions, substitutions and swaps of neighbours (Damerau, no substring edited twice).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(before, last);
    std::swap(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same(a[i - 1], b[j - 1]) ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1]);
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

/// Half of a short name, a quarter and one more of a longer one: 'schema' is not 'theta'.
std::size_t most_edits(std::size_t size) { return std::min(size / 2, 1 + size / 4); }

}  // namespace

std::string nearest_name(std::string_view name, std::span<const std::string> candidates) {
  std::string nearest;
  std::size_t least = most_edits(name.size()) + 1;
  for (const auto& candidate : candidates) {
    if (std::max(name.size(), candidate.size()) - std::min(name.size(), candidate.size()) >= least) continue;
    const auto distance = edit_distance(name, candidate);
    if (distance < least) {
      least = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string did_you_mean(std::string_view name, std::span<const std::string> candidates) {
  const auto near = nearest_name(name, candidates);
  return near.empty() ? "" : "; did you mean '" + near + "'?";
}

std::string accepted_instead(std::string_view name, std::span<const std::string> known) {
  return fmt::format("{}; accepted: {}", did_you_mean(name, known), fmt::join(known, ", "));
}

void refuse(std::string_view option, std::string_view value, std::string_view fault) {
  throw input_error(fmt::format("{} '{}': {}", option, one_line(value, 60), fault));
}

std::size_t choose(std::string_view option, std::string_view value, std::span<const std::string> known) {
  const auto found = std::ranges::find(known, value);
  if (found == known.end()) refuse(option, value, "not known" + accepted_instead(value, known));
  return static_cast<std::size_t>(found - known.begin());
}

}  // namespace polhode
