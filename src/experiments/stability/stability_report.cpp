// SPDX-License-Identifier: Apache-2.0
#include "experiments/stability/stability_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/common/judge.hpp"

namespace polhode {
namespace {

constexpr double rounding = 1e-9;

report::measurement limit_row(const stability_case& in, const finding& f) {
  const auto& [stable, broken] = f.limit;
  auto m = row_in(in, {"largest_stable_dt", "", "time", "sampled"}, {});
  if (stable > 0) m.value = m.low = in.dt(stable);
  if (broken > 0) m.high = in.dt(broken);
  if (broken == 0)
    m.status = "stable at every dt tried";
  else
    m.status = fmt::format("{}first broken: {}", stable > 0 ? "" : "broken at every dt tried, ", name_of(f.first));
  return m;
}

}  // namespace

void report_cases(const std::vector<stability_case>& cases, recorder& record) {
  for (const auto& c : cases) {
    record.row(row_in(c, {"fastest_rate", "", "per time", "exact"}, c.rate));
    record.row(row_in(c, {"horizon", "", "time", "exact"}, c.horizon));
    if (c.mean_energy) record.row(row_in(c, {"mean_energy", "", "", c.mean_energy_method}, c.mean_energy));
  }
}

void report_limits(const std::vector<stability_case>& cases, std::span<const finding> found, recorder& record) {
  for (std::size_t i = 0; i < cases.size(); ++i) record.row(limit_row(cases[i], found[i]));
}

void judge_orbit(const scheme_entry& scheme, const std::vector<stability_case>& cases, std::span<const finding> found,
                 recorder& record) {
  if (!scheme.info.casimir.exact) return;
  const bool bounded = cases.front().bounded;
  double casimir = 0, energy = 0;
  bool judged = false;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (!cases[i].normal) continue;
    const auto worst = bounded ? std::optional(found[i].worst_casimir) : found[i].worst_well_within();
    if (!worst) continue;
    judged = true;
    casimir = std::max(casimir, *worst);
    energy = std::max(energy, found[i].worst_energy);
  }
  // It rests on every path of every run, of which no row is kept.
  const char* of = bounded ? ", also in those that broke otherwise" : " up to half the largest stable dt";
  const auto say = [&](const char* claim, const char* what, double worst) {
    auto v = judge_distance({worst, worst, worst}, rounding,
                            fmt::format("{} off by at most {:.1e} in every run{}", what, worst, of));
    if (!std::isfinite(worst)) {
      v.kind = report::verdict_kind::refuted;
      v.reason = "a path was lost: not finite";
    }
    if (!judged) {
      v.kind = report::verdict_kind::inconclusive;
      v.reason = "no run is stable";
    }
    record.verdict(claim, v);
  };
  if (!bounded) return say("on its orbit up to half the largest stable dt", "the Casimirs of whole paths", casimir);
  say("on its orbit at every dt", "|Pi|", casimir);
  say("within the range of the energy at every dt", "the energy", energy);
}

}  // namespace polhode
