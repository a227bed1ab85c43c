// SPDX-License-Identifier: Apache-2.0
#include "cli/terminal/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "cli/terminal/layout.hpp"
#include "reports/model/text.hpp"
#include "reports/writers/numbers.hpp"
#include "reports/writers/origin.hpp"

namespace polhode::cli {
namespace {

using report::verdict_kind;
using report::verdict_kinds;
constexpr std::size_t narrow_board = 66, most_shown = 12;
using headings = std::array<std::string_view, verdict_kinds.size()>;
constexpr headings full{"holds", "refuted", "inconclusive", "not tried", "skipped"},
    brief{"holds", "ref", "inc", "n/t", "skip"};

const headings& headings_for(std::size_t width) { return width < narrow_board ? brief : full; }

struct row {
  std::string experiment;
  std::array<std::size_t, verdict_kinds.size()> counts{};
};

std::size_t index_of(verdict_kind kind) { return static_cast<std::size_t>(kind); }

row& row_of_experiment(std::vector<row>& rows, const std::string& experiment) {
  const auto found = std::ranges::find(rows, experiment, &row::experiment);
  return found != rows.end() ? *found : rows.emplace_back(row{.experiment = experiment});
}

/// In the order in which the experiments ran. Skipped counts a scheme once, whether it has a verdict for that or not.
std::vector<row> count(const report::results& r) {
  std::vector<row> rows;
  std::set<std::pair<std::string, std::string>> skipped;
  for (const auto& e : r.experiments) row_of_experiment(rows, e.name);
  for (const auto& v : r.verdicts) {
    if (v.kind == verdict_kind::skipped)
      skipped.insert({v.experiment, v.scheme});
    else
      ++row_of_experiment(rows, v.experiment).counts[index_of(v.kind)];
  }
  for (const auto& s : r.skipped) {
    if (s.experiment.empty()) continue;  // a scheme that does not run here stands in no row
    if (!s.scheme.empty())
      skipped.insert({s.experiment, s.scheme});
    else
      for (const auto& scheme : r.schemes) skipped.insert({s.experiment, scheme.name});
  }
  for (const auto& [experiment, scheme] : skipped)
    ++row_of_experiment(rows, experiment).counts[index_of(verdict_kind::skipped)];
  return rows;
}

std::string table(std::span<const row> rows, std::size_t width) {
  const auto& names = headings_for(width);
  const std::string gap(width < narrow_board ? 1 : 2, ' ');
  std::size_t first = std::string_view{"experiment"}.size();
  for (const auto& r : rows) first = std::max(first, display_width(r.experiment));
  auto out = fmt::format("{:<{}}", "experiment", first);
  for (const auto name : names) out += gap + std::string{name};
  for (const auto& r : rows) {
    out += fmt::format("\n{:<{}}", r.experiment, first);
    for (std::size_t k = 0; k < names.size(); ++k) out += gap + fmt::format("{:>{}}", r.counts[k], names[k].size());
  }
  return out + '\n';
}

/// A number that is not finite comes back from a file as none.
std::string shown_number(const std::optional<double>& x) {
  return report::finite(x) ? fmt::format("{:.4g}", *x) : "none";
}

std::string described(const report::verdict& v) {
  auto out = fmt::format("{}: {} {}: {}", name_of(v.kind), v.experiment, v.scheme, v.claim);
  if (v.expected) out += fmt::format(", claimed {}", shown_number(v.expected));
  if (v.estimate) out += fmt::format(", found {}", shown_number(v.estimate));
  if (v.low && v.high) out += fmt::format(" in [{}, {}]", shown_number(v.low), shown_number(v.high));
  return v.reason.empty() ? out : fmt::format("{} ({})", out, v.reason);
}

std::string not_holding(const report::results& r, std::size_t width) {
  std::string out;
  std::size_t hidden = 0, lines = 0;
  for (const auto kind : {verdict_kind::refuted, verdict_kind::inconclusive}) {
    for (const auto& v : r.verdicts) {
      if (v.kind != kind) continue;
      if (lines++ >= most_shown)
        ++hidden;
      else
        out += wrapped(one_line(described(v)), width, 2) + '\n';
    }
  }
  return hidden == 0 ? out : out + fmt::format("and {} more: see the report\n", hidden);
}

/// What this effort leaves out, once for all schemes that share the reason.
std::string not_tried(const report::results& r, std::size_t width) {
  std::vector<std::pair<std::string, std::size_t>> reasons;
  for (const auto& v : r.verdicts) {
    if (v.kind != verdict_kind::not_tried) continue;
    const auto text = fmt::format("not tried: {}: {}: {}", v.experiment, v.claim, v.reason);
    const auto known = std::ranges::find(reasons, text, &std::pair<std::string, std::size_t>::first);
    ++(known == reasons.end() ? reasons.emplace_back(text, 0) : *known).second;
  }
  std::string out;
  for (const auto& [text, schemes] : reasons)
    out += wrapped(one_line(fmt::format("{} ({} scheme{})", text, schemes, schemes == 1 ? "" : "s")), width, 2) + '\n';
  return out;
}

/// An experiment that says nothing about the whole scene does so with its reason.
std::string skipped_experiments(const report::results& r, std::size_t width) {
  std::string out;
  for (const auto& s : r.skipped) {
    if (!s.scheme.empty()) continue;
    out += wrapped(one_line(fmt::format("skipped: {}: {}", s.experiment, s.reason)), width, 2) + '\n';
  }
  return out;
}

std::string reuse(const report::results& r, std::size_t width) {
  if (r.reused.empty()) return "";
  double seconds = 0;
  for (const auto& one : r.reused) seconds += one.saved.cpu_seconds;
  return wrapped(
             fmt::format("{} of {} results were computed earlier, which saves {} of CPU time; --fresh computes anew",
                         r.done.results_reused, r.done.results_reused + r.done.results_computed,
                         report::shown_duration(seconds)),
             width, 2) +
         '\n';
}

/// Schemes that do not run on this scene, by reason.
std::string absent_schemes(const report::results& r, std::size_t width) {
  std::vector<std::pair<std::string, std::string>> reasons;  // reason, names
  for (const auto& s : r.skipped) {
    if (!s.experiment.empty()) continue;
    const auto known = std::ranges::find(reasons, s.reason, &std::pair<std::string, std::string>::first);
    if (known == reasons.end())
      reasons.emplace_back(s.reason, s.scheme);
    else
      known->second += ", " + s.scheme;
  }
  std::string out;
  for (const auto& [reason, names] : reasons)
    out += wrapped(one_line(fmt::format("not run here: {}: {}", names, reason)), width, 2) + '\n';
  return out;
}

std::string origins(const report::results& r, std::size_t width) {
  std::string out;
  for (const auto& s : r.schemes)
    if (const auto origin = report::origin_of(s); !origin.empty()) out += wrapped(one_line(origin), width, 2) + '\n';
  return out;
}

std::string totals(std::span<const row> rows, std::size_t width) {
  const auto& names = headings_for(width);
  std::string out;
  for (std::size_t k = 0; k < names.size(); ++k) {
    std::size_t sum = 0;
    for (const auto& r : rows) sum += r.counts[k];
    out += fmt::format("{}{} {}", k == 0 ? "" : ", ", sum, names[k]);
  }
  return out + '\n';
}

}  // namespace

std::string summary(const report::results& r, std::size_t width) {
  const auto rows = count(r);
  auto out = wrapped(fmt::format("{} ({})", one_line(r.scene.name), r.scene.system), width) + '\n';
  out += table(rows, width) + absent_schemes(r, width) + skipped_experiments(r, width) + not_tried(r, width) +
         not_holding(r, width) + origins(r, width) + reuse(r, width);
  return out + totals(rows, width);
}

int exit_code(std::span<const report::results> all) {
  bool inconclusive = false;
  for (const auto& r : all) {
    inconclusive = inconclusive || (r.schemes.empty() && !r.skipped.empty());  // none of those asked for runs here
    inconclusive = inconclusive || !r.to_come.empty();                         // the budget was used up
    for (const auto& v : r.verdicts) {
      if (v.kind == verdict_kind::refuted) return 1;
      inconclusive = inconclusive || v.kind == verdict_kind::inconclusive;
    }
  }
  return inconclusive ? 3 : 0;
}

}  // namespace polhode::cli
