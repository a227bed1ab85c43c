// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/left_out.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "reports/writers/numbers.hpp"

namespace polhode::report {
namespace {

std::string shown_count(std::uint64_t count) {
  return count < 10'000 ? fmt::format("{}", count) : shown(static_cast<double>(count));
}

std::string shown_saved(const saved& s) {
  std::vector<std::string> parts;
  const auto add = [&](std::uint64_t count, const char* what) {
    if (count > 0) parts.push_back(fmt::format("{} {}", shown_count(count), what));
  };
  add(s.work.normals_drawn, "normals");
  add(s.work.path_steps, "path-steps");
  add(s.work.kernels_run, "kernel calls");
  if (s.cpu_seconds > 0) parts.push_back(shown_duration(s.cpu_seconds) + " of CPU time");
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string schemes_of(const std::string& scheme) { return scheme.empty() ? "every scheme" : scheme; }

void add_saved(const saved& more, saved& sum) {
  sum.work.normals_drawn += more.work.normals_drawn;
  sum.work.path_steps += more.work.path_steps;
  sum.work.kernels_run += more.work.kernels_run;
  sum.cpu_seconds += more.cpu_seconds;
}

struct reuse_group {
  const reuse* first;
  std::size_t schemes = 0;
  saved sum{};
};

std::vector<reuse_group> grouped(const std::vector<reuse>& all) {
  std::vector<reuse_group> groups;
  for (const auto& one : all) {
    auto group = std::ranges::find_if(groups, [&](const reuse_group& g) {
      return g.first->experiment == one.experiment && g.first->computed == one.computed;
    });
    if (group == groups.end()) group = groups.insert(groups.end(), {&one});
    ++group->schemes;
    add_saved(one.saved, group->sum);
  }
  return groups;
}

}  // namespace

std::vector<left_out> left_out_of(const results& r) {
  std::vector<left_out> rows;
  for (const auto& s : r.skipped)
    rows.push_back({left_out::kind::skip, s.experiment, schemes_of(s.scheme), s.reason, shown_saved(s.saved)});
  for (const auto& s : r.savings)
    rows.push_back({left_out::kind::saving, s.experiment, schemes_of(s.scheme), fmt::format("{}: {}", s.what, s.reason),
                    shown_saved(s.saved)});
  for (const auto& g : grouped(r.reused))
    rows.push_back({left_out::kind::reuse, g.first->experiment,
                    g.schemes == 1 ? g.first->scheme : fmt::format("{} schemes", g.schemes),
                    fmt::format("taken from a run of {}: the same inputs, the same build", g.first->computed),
                    shown_saved(g.sum)});
  return rows;
}

std::string work_sentence(const results& r) {
  const auto& d = r.done;
  auto out = fmt::format("A result is what one experiment says of one scheme: {} computed in this run, {} taken over.",
                         shown_count(d.results_computed), shown_count(d.results_reused));
  if (d.work != counters{})
    out +=
        fmt::format(" This run drew {} normals and took {} path-steps in {} kernel calls.",
                    shown_count(d.work.normals_drawn), shown_count(d.work.path_steps), shown_count(d.work.kernels_run));
  return out;
}

}  // namespace polhode::report
