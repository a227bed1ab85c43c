// SPDX-License-Identifier: Apache-2.0
#include "experiments/stability/stability_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/judge.hpp"
#include "experiments/common/levels.hpp"
#include "problem/vectors.hpp"

namespace polhode {
namespace {

constexpr double resolution = 16;  // steps to a time scale
constexpr int scale_steps = 64;
constexpr double bound = 1e-9, decades = 150;

/// One block of paths after 64 steps at |Pi| times 4^power, as they would be times 4^unit.
std::vector<double> states_at(const context& c, const scheme_entry& named, int power, int unit) {
  const auto s = c.subject.with(c.subject.offers->in_unit(power));
  const auto& scheme = *std::ranges::find(s.schemes, named.info.name, [](const auto& e) { return e.info.name; });
  const double dt = std::ldexp(1 / (resolution * fastest_rate(c.subject)), -2 * power);
  increment_buffer noise(*s.model, scale_steps, scheme.needs_areas, {c.generator, noise_quality::fast});
  auto states = replicated(s.scene.momentum);
  scheme.make(dt)->advance(
      states, !s.model->layout().silent() ? noise.fill(c.seed, 0, 0, scale_steps, dt) : silence(scale_steps));
  for (double& x : states) x = std::ldexp(x, 2 * (unit - power));
  return states;
}

/// Relative to the length.
double distance_between(const std::vector<double>& a, const std::vector<double>& b, double length) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double apart = std::fabs(a[i] - b[i]) / length;
    worst = std::isfinite(apart) ? std::max(worst, apart) : std::numeric_limits<double>::infinity();
  }
  return worst;
}

/// The last power between `near`, where all is well, and `far`, where it is not, at which it still is.
template <class Good>
int last_good(int near, int far, const Good& good) {
  while (std::abs(far - near) > 1) {
    const int middle = (near + far) / 2;
    (good(middle) ? near : far) = middle;
  }
  return near;
}

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

void report_scale(const context& c, const scheme_entry& scheme, recorder& record) {
  if (!c.subject.offers->in_unit) return;
  const double own = length(c.subject.scene.momentum);
  if (std::fabs(std::log10(own)) > decades) return;  // neither could its theta and sigma be scaled
  const auto power_of = [&](double decade) {
    return static_cast<int>(std::lround((decade - std::log10(own)) / std::log10(4)));
  };
  const int unit = power_of(0);  // whatever the scene's |Pi|, what is of size 1 is the measure
  const double size = std::ldexp(own, 2 * unit);
  const auto start = states_at(c, scheme, unit, unit);
  const auto off = [&](int power) { return distance_between(states_at(c, scheme, power, unit), start, size); };
  const auto good = [&](int power) { return off(power) <= bound; };
  double worst = 0;
  std::string reach;
  std::vector<report::series_id> evidence;
  for (const double end : {-decades, decades}) {
    const int far = power_of(end);
    const double apart = off(far);
    worst = std::max(worst, apart);
    const int reached = apart <= bound ? far : last_good(unit, far, good);
    const double c_reached = std::ldexp(own, 2 * reached);
    reach += fmt::format("{}{:.0e}", reach.empty() ? "" : " to ", c_reached);
    const char* name = end < 0 ? "scale_free_from" : "scale_free_to";
    evidence.push_back(record.value({name, "c", "momentum", "deterministic"}, c_reached));
  }
  auto v = judge_distance({worst, worst, worst}, bound,
                          fmt::format("off by at most {:.1e}; the same from |Pi| = {}", worst, reach));
  if (!std::isfinite(worst)) v.kind = report::verdict_kind::refuted;
  record.verdict("scale-free for |Pi| from 1e-150 to 1e150", v, evidence);
}

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
