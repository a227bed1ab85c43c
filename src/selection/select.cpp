// SPDX-License-Identifier: Apache-2.0
#include "selection/select.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "ensemble/noise/paths.hpp"
#include "reports/model/errors.hpp"
#include "selection/goal.hpp"
#include "selection/search.hpp"
#include "selection/snippet.hpp"

namespace polhode {
namespace {

// What a user may require of a scheme besides its accuracy.

const std::vector<std::string>& requirements() {
  static const std::vector<std::string> all{"casimir-exact", "explicit", "implicit", "no-areas", "monotone-energy"};
  return all;
}

/// What the candidate lacks; empty: nothing that its info can tell.
std::optional<std::string> lacks(const candidate& c, const std::vector<std::string>& wanted) {
  for (const auto& name : wanted) {
    if (name == "casimir-exact" && !c.scheme.info.casimir.exact) return "does not keep the Casimir (required)";
    if (name == "explicit" && c.scheme.info.implicit) return "implicit (explicit is required)";
    if (name == "implicit" && !c.scheme.info.implicit) return "explicit (implicit is required)";
    if (name == "no-areas" && c.scheme.needs_areas) return "needs Levy areas (no areas is required)";
  }
  return std::nullopt;
}

/// Throws input_error on an unknown name, on a contradiction, and where no candidate has all that its info can tell.
void check_requirements(const std::vector<std::string>& wanted, const std::vector<candidate>& all) {
  const auto has = [&](const char* name) { return std::ranges::find(wanted, name) != wanted.end(); };
  for (const auto& name : wanted)
    if (std::ranges::find(requirements(), name) == requirements().end())
      throw input_error(fmt::format("--require '{}': not known; accepted: {}", name, fmt::join(requirements(), ", ")));
  if (has("explicit") && has("implicit"))
    throw input_error("--require 'explicit,implicit': contradictory; accepted: one of the two");
  if (std::ranges::all_of(all, [&](const candidate& c) { return lacks(c, wanted).has_value(); }))
    throw input_error(
        fmt::format("--require '{}': no scheme has all of these; see polhode list schemes", fmt::join(wanted, ",")));
}

/// Does the energy never rise in a run without noise at this dt?
bool monotone_energy(const subject& s, const candidate& c, double dt) {
  constexpr int steps = 4096;
  constexpr double rounding = 1e-14;
  const auto still = s.without_noise();
  const auto stepper = c.scheme.make(dt);
  auto states = replicated(still.scene.momentum);
  double before = still.model->energy(still.scene.momentum);
  for (int i = 0; i < steps; ++i) {
    stepper->advance(states, silence(1));
    const double h = still.model->energy(lane_of(states, 0, still.model->dimension()));
    if (!(h <= before + rounding * std::fabs(before))) return false;
    before = h;
  }
  return true;
}

// What the measured error laws say to the questions that people ask about integrators.

/// Schemes that keep the Casimir exactly, at the winner's step.
std::string on_keeping_the_casimir(const std::vector<prospect>& all, const choice& winner) {
  const prospect *best = nullptr, *worst = nullptr;
  const auto error = [&](const prospect* p) { return p->law->at(winner.dt); };
  for (const auto& p : all) {
    if (!p.law || !p.who.scheme.info.casimir.exact || p.who.combination != nullptr) continue;
    if (!best || error(&p) < error(best)) best = &p;
    if (!worst || error(&p) > error(worst)) worst = &p;
  }
  if (!best || best == worst || error(worst) < 2 * error(best)) return "";
  return fmt::format(
      "keeping |Pi| is not accuracy: at dt = {:.3g} {} and {} both keep it, with errors of about {:.1e} and "
      "{:.1e}",
      winner.dt, best->who.name, worst->who.name, error(best), error(worst));
}

/// cost = k (factor / tolerance)^(1/order): where two such laws cross.
double crossing(const prospect& low, const prospect& high) {
  const double k = std::log(high.cost * high.dt) - std::log(low.cost * low.dt);
  const double a = 1 / low.law->order, b = 1 / high.law->order;
  return std::exp((a * std::log(low.law->factor) - b * std::log(high.law->factor) - k) / (a - b));
}

/// The cheapest scheme of a higher order than the winner's, and below which tolerance it pays.
std::string on_higher_order(const std::vector<prospect>& all, const choice& winner, double tolerance) {
  const auto first = std::ranges::find(all, winner.scheme, [](const prospect& p) { return p.who.name; });
  for (const auto& p : all) {  // by rising cost
    if (!p.law || !p.fault.empty() || p.law->order < first->law->order + 0.4 || p.who.name == winner.scheme) continue;
    const double t = crossing(*first, p);
    if (!(t < tolerance) || p.who.scheme.needs_areas) return "";
    return fmt::format("order {:.2g} ({}) is not cheaper here; it is below a tolerance of about {:.0e}", p.law->order,
                       p.who.name, t);
  }
  return "";
}

/// Sentences on keeping |Pi| and on higher order, from this scene's own error laws; by predicted costs.
std::vector<std::string> advice(const std::vector<prospect>& all, const choice& winner, double tolerance) {
  std::vector<std::string> out;
  for (auto text : {on_keeping_the_casimir(all, winner), on_higher_order(all, winner, tolerance)})
    if (!text.empty()) out.push_back(std::move(text));
  return out;
}

bool is_required(const std::vector<std::string>& wanted, const char* name) {
  return std::ranges::find(wanted, name) != wanted.end();
}

/// Error laws in parallel, prices one by one; by rising predicted cost, those that are out last.
std::vector<prospect> prospects_of(const context& c, const search& s, const std::vector<candidate>& candidates,
                                   const std::vector<std::string>& wanted) {
  std::vector<prospect> out(candidates.size());
  parallel_for(c.threads, static_cast<int>(candidates.size()), [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    const auto lacking = lacks(candidates[k], wanted);
    out[k] = lacking ? prospect{candidates[k], {}, 0, 0, *lacking} : s.predict(candidates[k]);
  });
  for (auto& p : out) s.price(p);
  std::ranges::stable_sort(out, [](const prospect& a, const prospect& b) {
    return a.fault.empty() != b.fault.empty() ? a.fault.empty() : a.cost < b.cost;
  });
  return out;
}

/// Checks in the order of predicted cost until nobody left can undercut the two best.
void check_all(const context& c, const search& s, const std::vector<std::string>& wanted,
               std::vector<prospect>& prospects, std::vector<choice>& met) {
  constexpr double margin = 1.5;  // a prediction may be off by this
  for (auto& p : prospects) {
    if (!p.fault.empty()) continue;
    if (met.size() >= 2 && p.cost > margin * met[1].cost) break;
    const auto found = s.check(p, p.fault);
    if (!found) continue;
    if (is_required(wanted, "monotone-energy") && !monotone_energy(c.subject, p.who, found->dt)) {
      p.fault = fmt::format("its energy rises without noise at dt = {:.3g} (monotone energy is required)", found->dt);
      continue;
    }
    p.fault.clear();
    met.push_back(*found);
    std::ranges::stable_sort(met, {}, &choice::cost);
  }
}

std::string loss_of(const prospect& p, const choice* met, const std::optional<choice>& winner) {
  if (!p.law || (!met && p.cost == 0)) return p.fault;
  const double times = winner ? (met ? met->cost : p.cost) / winner->cost : 0;
  std::string out = winner ? fmt::format("{:.3g} times the cost, ", times) : "";
  out += fmt::format("dt = {:.3g}, order {:.2f}", met ? met->dt : p.dt, p.law->order);
  if (!met) out += p.fault.empty() ? " (predicted)" : fmt::format(" (predicted); {}", p.fault);
  return out;
}

void explain(const std::vector<prospect>& prospects, const std::vector<choice>& met, selection& out) {
  for (const auto& p : prospects) {
    if (out.winner && p.who.name == out.winner->scheme) continue;
    const auto found = std::ranges::find(met, p.who.name, &choice::scheme);
    out.rejected.push_back({p.who.name, loss_of(p, found == met.end() ? nullptr : &*found, out.winner)});
  }
}

/// The cheapest by its error law among those that could be asked.
void say_closest(const std::vector<prospect>& prospects, selection& out) {
  for (const auto& p : prospects)
    if (p.law) {
      constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
      const double error = p.law->at(p.dt);
      out.closest = choice{p.who.name, p.dt, error, unknown, unknown, p.law->order, p.cost, p.cost, p.cost};
      out.reason = fmt::format("no scheme was seen to meet it; {} by its error law would at dt = {:.3g}, but {}",
                               p.who.name, p.dt, p.fault.empty() ? "was not checked" : p.fault);
      return;
    }
  out.reason = "no scheme could be asked";
}

/// What the answer covers: all observables and which is the worst, or what it is silent on and the worst of that.
void say_observables(const goal_question& q, const choice& winner, selection& out) {
  for (const auto& o : winner.observed) {
    const bool asked = q.observable == o.observable;
    if (q.observable != all_observables && !asked) out.silent_on.push_back(o.observable);
    if (!asked && (!out.worst_observable || o.bound() > out.worst_observable->bound())) out.worst_observable = o;
  }
}

}  // namespace

selection select(const context& c, const goal_question& q, const std::vector<std::string>& require) {
  const auto goal = make_goal(c, q);
  const auto candidates = goal->candidates(c.subject);
  check_requirements(require, candidates);
  const search s(c, *goal, q);
  selection out;
  out.question = q;
  out.unit = goal->unit();
  out.notes = goal->notes();
  auto prospects = prospects_of(c, s, candidates, require);
  std::vector<choice> met;
  check_all(c, s, require, prospects, met);
  if (!met.empty()) out.winner = met[0];
  if (met.size() > 1) {
    out.runner_up = met[1];
    out.tied = met[1].cost_low <= met[0].cost_high;
  }
  if (met.empty()) say_closest(prospects, out);
  explain(prospects, met, out);
  if (out.winner) say_observables(q, *out.winner, out);
  if (out.winner) std::ranges::copy(advice(prospects, *out.winner, q.tolerance), std::back_inserter(out.notes));
  if (!out.winner || c.subject.offers->in_cpp.empty()) return out;
  const auto who = std::ranges::find(candidates, out.winner->scheme, &candidate::name);
  const int channels = std::max(1, c.subject.model->layout().active);
  const int cells = 1 + static_cast<int>(std::lround(goal->further_normals(*who, out.winner->dt) / channels));
  out.snippet = snippet(c.subject, *who, out.winner->dt, q.time, cells);
  return out;
}

}  // namespace polhode
