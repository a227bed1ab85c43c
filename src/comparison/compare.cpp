// SPDX-License-Identifier: Apache-2.0
#include "comparison/compare.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "comparison/claims.hpp"
#include "comparison/numbers.hpp"
#include "comparison/timings.hpp"
#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"

namespace polhode {
namespace {

using report::change;
using report::comparison;
using report::results;

std::string to_come_of(const results& r) {
  return r.to_come.empty() ? "nothing" : fmt::format("{}", fmt::join(r.to_come, ", "));
}

/// What differs between the runs themselves.
void compare_settings(const results& before, const results& after, comparison& out) {
  const auto& a = before.provenance;
  const auto& b = after.provenance;
  const auto note = [&](std::string_view what, const auto& x, const auto& y) {
    if (x != y) out.settings.push_back(fmt::format("{}: {}, now {}", what, x, y));
  };
  note("version", a.version, b.version);
  note("commit", a.commit, b.commit);
  note("compiler", a.compiler, b.compiler);
  note("flags", a.flags, b.flags);
  note("processor", a.cpu, b.cpu);
  note("instruction set", a.isa, b.isa);
  note("generator", a.generator, b.generator);
  note("threads", a.threads, b.threads);
  note("seed", a.seed, b.seed);
  note("effort", a.effort, b.effort);
  note("unfinished, still to come", to_come_of(before), to_come_of(after));
  if (a.cpu != b.cpu || a.isa != b.isa || a.compiler != b.compiler || a.flags != b.flags)
    out.timings_left_out = "processor, instruction set, compiler or flags differ";
}

}  // namespace

void check_same_scene(const report::scene& a, const report::scene& b) {
  const auto differ = [&](std::string_view key) {
    throw input_error(
        fmt::format("the two results are of different scenes ({} differs: '{}' and '{}'); accepted: two "
                    "results of one scene",
                    one_line(key, 60), one_line(a.name, 60), one_line(b.name, 60)));
  };
  if (a.system != b.system) differ("system");
  for (const auto& p : a.parameters) {
    const auto other = std::ranges::find(b.parameters, p.name, &report::parameter::name);
    if (other == b.parameters.end() || !(*other == p)) differ(p.name);
  }
  for (const auto& p : b.parameters)
    if (std::ranges::find(a.parameters, p.name, &report::parameter::name) == a.parameters.end()) differ(p.name);
  if (a.momentum != b.momentum) differ("momentum");
  if (a.horizon != b.horizon) differ("horizon");
}

comparison compare(const results& before, const results& after) {
  check_same_scene(before.scene, after.scene);
  comparison out;
  out.scene = after.scene.name;
  compare_settings(before, after, out);
  compare_claims(before, after, out);
  compare_numbers(before, after, out);
  compare_timings(before, after, out);
  std::ranges::stable_sort(out.changes, {}, &change::kind);
  return out;
}

}  // namespace polhode
