// SPDX-License-Identifier: Apache-2.0
#include "comparison/claims.hpp"

#include <map>
#include <set>
#include <string>
#include <tuple>

namespace polhode {
namespace {

using report::change;
using report::change_kind;
using report::comparison;
using report::results;
using report::verdict_kind;

change_kind kind_of(verdict_kind before, verdict_kind after) {
  if (after == verdict_kind::refuted) return change_kind::worse;
  if (before == verdict_kind::refuted || after == verdict_kind::holds) return change_kind::better;
  return before == verdict_kind::holds ? change_kind::unsure : change_kind::different;
}

}  // namespace

void compare_claims(const results& before, const results& after, comparison& out) {
  using key = std::tuple<std::string, std::string, std::string>;
  const auto key_of = [](const report::verdict& v) { return key{v.experiment, v.scheme, v.claim}; };
  std::map<key, const report::verdict*> now;
  for (const auto& v : after.verdicts) now.emplace(key_of(v), &v);
  std::set<std::string> experiments, schemes;
  for (const auto& e : after.experiments) experiments.insert(e.name);
  for (const auto& s : after.schemes) schemes.insert(s.name);
  for (const auto& v : before.verdicts) {
    const auto found = now.find(key_of(v));
    change c{change_kind::unsure, v.experiment, v.scheme, v.claim, {}, v.estimate, v.low, v.high, {}, {}, {}, {}, {}};
    c.text_before = name_of(v.kind);
    if (found == now.end()) {
      // What was not asked this time has not changed.
      if (!experiments.contains(v.experiment) || (!v.scheme.empty() && !schemes.contains(v.scheme))) continue;
      c.text_after = "not claimed";
      if (v.kind == verdict_kind::holds) out.changes.push_back(c);
      continue;
    }
    ++out.claims;
    const auto& w = *found->second;
    if (w.kind == v.kind) continue;
    c.kind = kind_of(v.kind, w.kind);
    c.text_after = name_of(w.kind);
    c.after = w.estimate;
    c.after_low = w.low;
    c.after_high = w.high;
    out.changes.push_back(c);
  }
}

}  // namespace polhode
