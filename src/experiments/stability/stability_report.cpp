#include "experiments/stability/stability_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/common/judge.hpp"

namespace polhode {
namespace {

constexpr double rounding = 1e-9;

report::measurement border_row(const stability_case& in, const scheme_entry& scheme, const finding& f) {
  auto m = stability_row(scheme.info.name, "largest_stable_dt", in.name, {}, "time", "sampled");
  if (f.border.stable > 0) m.value = m.low = in.dt(f.border.stable);
  if (f.border.broken > 0) m.high = in.dt(f.border.broken);
  if (f.border.broken == 0)
    m.status = "stable at every dt tried";
  else
    m.status =
        fmt::format("{}first broken: {}", f.border.stable > 0 ? "" : "broken at every dt tried, ", name_of(f.first));
  return m;
}

}  // namespace

void report_cases(const std::vector<stability_case>& cases, report::results& out) {
  const auto row = [&](const stability_case& c, const char* quantity, double value, const char* unit,
                       const std::string& method) {
    out.measurements.push_back(stability_row("", quantity, c.name, value, unit, method));
  };
  for (const auto& c : cases) {
    row(c, "fastest_rate", c.rate, "per time", "exact");
    row(c, "horizon", c.horizon, "time", "exact");
    if (c.mean_energy) row(c, "mean_energy", *c.mean_energy, "", c.mean_energy_method);
  }
}

void report_borders(const scheme_entry& scheme, const std::vector<stability_case>& cases,
                    std::span<const finding> found, report::results& out) {
  for (std::size_t i = 0; i < cases.size(); ++i) out.measurements.push_back(border_row(cases[i], scheme, found[i]));
}

void judge_orbit(const scheme_entry& scheme, const std::vector<stability_case>& cases, std::span<const finding> found,
                 report::results& out) {
  if (!scheme.info.casimir.exact) return;
  double casimir = 0, energy = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (!cases[i].normal) continue;
    casimir = std::max(casimir, found[i].worst_casimir);
    energy = std::max(energy, found[i].worst_energy);
  }
  const std::string name(scheme.info.name);
  const auto say = [&](const char* text, const char* what, double worst) {
    auto v = judge_distance(
        {"stability", name, text}, {worst, worst, worst}, rounding,
        fmt::format("{} off by at most {:.1e} in every run, also in those that broke otherwise", what, worst));
    if (!std::isfinite(worst)) {
      v.kind = report::verdict_kind::refuted;
      v.reason = "a path was lost: not finite";
    }
    out.verdicts.push_back(v);
  };
  say("on its orbit at every dt", "|Pi|", casimir);
  say("within the range of the energy at every dt", "the energy", energy);
}

}  // namespace polhode
