// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/board.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace polhode::report {
namespace {

void add_once(std::vector<std::string>& names, const std::string& name) {
  if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

std::string counted(std::size_t number, std::string_view what) {
  return fmt::format("{} {} {}", number, number == 1 ? "is" : "are", what);
}

}  // namespace

std::size_t tally::total() const { return std::accumulate(counts.begin(), counts.end(), std::size_t{0}); }

tally count(const std::vector<verdict>& verdicts) {
  tally total;
  for (const auto& row : verdicts) total.add(row.kind);
  return total;
}

std::string headline(const tally& t) {
  const auto claims = [](std::size_t n) { return fmt::format("{} claim{}", n, n == 1 ? "" : "s"); };
  const std::size_t refuted = t.of(verdict_kind::refuted), open = t.of(verdict_kind::inconclusive);
  if (refuted > 0) return fmt::format("{} {} refuted.", claims(refuted), refuted == 1 ? "is" : "are");
  if (open > 0) return fmt::format("Nothing is refuted, but {} remain{} open.", claims(open), open == 1 ? "s" : "");
  return t.of(verdict_kind::holds) > 0 ? "Every claim that was tried holds." : "No claim was tried.";
}

std::string sentence(const tally& t) {
  const std::size_t holding = t.of(verdict_kind::holds);
  auto out =
      fmt::format("{} claim{}: {} {}", t.total(), t.total() == 1 ? "" : "s", holding, holding == 1 ? "holds" : "hold");
  for (const auto kind : verdict_kinds)
    if (kind != verdict_kind::holds) out += ", " + counted(t.of(kind), name_of(kind));
  return out + ".";
}

const experiment* find_experiment(const results& r, std::string_view name) {
  const auto found =
      std::find_if(r.experiments.begin(), r.experiments.end(), [&](const auto& one) { return one.name == name; });
  return found == r.experiments.end() ? nullptr : &*found;
}

std::vector<const verdict*> verdicts_of(const results& r, std::string_view experiment) {
  std::vector<const verdict*> rows;
  for (const auto& row : r.verdicts)
    if (row.experiment == experiment) rows.push_back(&row);
  return rows;
}

std::vector<const fit*> fits_of(const results& r, std::string_view experiment) {
  std::vector<const fit*> rows;
  for (const auto& row : r.fits)
    if (row.experiment == experiment) rows.push_back(&row);
  return rows;
}

std::vector<std::string> claims_of(const std::vector<const verdict*>& rows) {
  std::vector<std::string> claims;
  for (const auto* row : rows) add_once(claims, row->claim);
  return claims;
}

}  // namespace polhode::report
