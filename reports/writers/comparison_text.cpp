// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/comparison_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "reports/model/text.hpp"
#include "reports/writers/numbers.hpp"

namespace polhode::report {
namespace {

constexpr std::array<change_kind, 4> kinds{change_kind::worse, change_kind::unsure, change_kind::better,
                                           change_kind::different};

std::string side_text(const std::string& text, std::optional<double> value, std::optional<double> low,
                      std::optional<double> high) {
  std::string out = text;
  if (value || text.empty()) out += (out.empty() ? "" : " ") + shown(value);
  if (const auto interval = shown_interval(low, high); !interval.empty() && value) out += ' ' + interval;
  return out;
}

}  // namespace

std::string_view heading_of(change_kind kind) {
  switch (kind) {
    case change_kind::worse: return "worse";
    case change_kind::unsure: return "no longer shown to hold";
    case change_kind::better: return "better";
    case change_kind::different: return "different";
  }
  return "different";
}

std::string line_of(const change& c) {
  std::string out = c.experiment;
  if (!c.scheme.empty()) out += ' ' + c.scheme;
  out += ": " + c.what;
  if (c.dt) out += fmt::format(", dt = {}", shown(c.dt));
  return one_line(fmt::format("{}: {}, now {}", out, side_text(c.text_before, c.before, c.before_low, c.before_high),
                              side_text(c.text_after, c.after, c.after_low, c.after_high)));
}

namespace {

/// What is told together: an experiment, a scheme, and whether it is a number that has moved. Verdicts stand alone.
bool together(const change& a, const change& b) {
  const auto number = [](const change& c) { return c.text_before.empty() && c.text_after.empty(); };
  return a.experiment == b.experiment && a.scheme == b.scheme && number(a) && number(b);
}

/// How far a number has moved, as a factor.
double factor_of(const change& c) {
  const double ratio = std::fabs(c.after.value_or(0) / c.before.value_or(0));
  return ratio > 0 && std::isfinite(ratio) ? std::fabs(std::log(ratio)) : HUGE_VAL;
}

/// One line a cause: of the numbers of a scheme in an experiment the one that moved most, and how many with it.
std::vector<std::string> lines_of(const comparison& c, change_kind kind) {
  struct cause {
    const change* most;
    std::size_t count = 1;
  };
  std::vector<cause> causes;
  for (const auto& x : c.changes) {
    if (x.kind != kind) continue;
    const auto known = std::ranges::find_if(causes, [&](const cause& one) { return together(*one.most, x); });
    if (known == causes.end()) {
      causes.push_back({&x});
      continue;
    }
    ++known->count;
    if (factor_of(x) > factor_of(*known->most)) known->most = &x;
  }
  std::vector<std::string> out;
  for (const auto& one : causes) {
    out.push_back(line_of(*one.most));
    if (one.count > 1) out.back() += fmt::format("; and {} more of its numbers", one.count - 1);
  }
  return out;
}

}  // namespace

std::string to_text(const comparison& c, std::size_t most) {
  std::string out = fmt::format("{}: {} claims and {} numbers compared", one_line(c.scene), c.claims, c.numbers);
  if (c.timings > 0) out += fmt::format(", {} timings", c.timings);
  out += '\n';
  for (const auto& s : c.settings) out += fmt::format("  {}\n", one_line(s));
  if (c.without_interval > 0)
    out += fmt::format("{} sampled numbers without an interval are not compared\n", c.without_interval);
  if (!c.timings_left_out.empty()) out += fmt::format("timings are not compared: {}\n", c.timings_left_out);
  for (const auto kind : kinds) {
    const auto all = std::ranges::count(c.changes, kind, &change::kind);
    if (all == 0) continue;
    out += fmt::format("\n{}: {}\n", heading_of(kind), all);
    const auto lines = lines_of(c, kind);
    for (std::size_t i = 0; i < std::min(most, lines.size()); ++i) out += fmt::format("  {}\n", lines[i]);
    if (lines.size() > most) out += fmt::format("  … and {} more (--format json has all)\n", lines.size() - most);
  }
  if (c.changes.empty()) out += "nothing has changed beyond noise\n";
  return out;
}

}  // namespace polhode::report
