// SPDX-License-Identifier: Apache-2.0
// What does an accuracy cost, and with which scheme is it cheapest?
//
// The errors are those that the other experiments of this run found (known_errors.hpp); the cost of a step is measured
// here (step_cost.hpp), at every dt at which an error is known.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "experiments/common/operator_work.hpp"
#include "experiments/common/recorder.hpp"
#include "experiments/laws/extrapolation.hpp"
#include "experiments/work_precision/cost_front.hpp"
#include "experiments/work_precision/known_errors.hpp"
#include "experiments/work_precision/price_list.hpp"

namespace polhode {
namespace {

constexpr int finest_accuracy = 12;  // of the table: 10^-12

quantity cost_quantity(const char* name, const std::string& of) {
  return {name, of, "ns per path and unit of time", "timed"};
}

report::measurement row_at(double dt, const quantity& what, double value, double low, double high) {
  auto m = row_of(what, value, low, high);
  m.set_over(at_dt(dt));
  return m;
}

/// The points of a kind, and what needs no clock.
std::vector<cost_point> priced(const error_kind& kind, const price_list& prices, const recorder& record) {
  std::vector<cost_point> points;
  for (const auto& e : kind.errors) {
    const auto p =
        kind.along_paths ? prices.of_path_with_cells(e.scheme, e.dt) : prices.of_path(e.scheme, e.dt, kind.silent);
    if (!p) continue;
    points.push_back({e.scheme, e.dt, e.value, e.low, e.high, p->ns, p->low, p->high});
    auto of_scheme = record.of(e.scheme);
    of_scheme.value({"steps_per_time", kind.name, "steps per path and unit of time", "counted"}, at_dt(e.dt), p->steps);
    of_scheme.value({"normals_per_time", kind.name, "normals per path and unit of time", "counted"}, at_dt(e.dt),
                    p->normals);
  }
  return points;
}

void report_points(const error_kind& kind, const std::vector<cost_point>& points, const recorder& record) {
  for (const auto& p : points) {
    auto cost = row_at(p.dt, cost_quantity("cost", kind.name), p.cost, p.cost_low, p.cost_high);
    auto error = row_at(p.dt, {"error_at_cost", kind.name, kind.unit, kind.source}, p.error, p.error_low, p.error_high);
    cost.used = error.used = p.front;
    cost.status = error.status = p.front ? "on the front" : p.resolved() ? "ok" : "not clear of its uncertainty";
    auto of_scheme = record.of(p.scheme);
    of_scheme.row(std::move(cost));
    of_scheme.row(std::move(error));
  }
}

/// An error of a kind, to be reached.
struct aim {
  std::string kind;
  double accuracy;
  report::coordinate place() const { return {"accuracy", accuracy}; }
};

/// One line of the table: the schemes that reach it from the cheapest on, each against the next.
void report_ranking(const aim& to, const std::vector<reached>& ranked, const recorder& record) {
  for (std::size_t i = 0; i < ranked.size(); ++i) {
    const auto& r = ranked[i];
    auto of_scheme = record.of(r.scheme);
    auto cost = row_at(r.dt, cost_quantity("cost_to_reach", to.kind), r.cost, r.low, r.high);
    cost.set_over(to.place());
    cost.used = i == 0;
    if (r.coarsest) cost.status = "at the coarsest dt measured";
    of_scheme.row(std::move(cost));
    if (i + 1 == ranked.size()) continue;
    const auto& next = ranked[i + 1];
    auto ratio =
        row_at(r.dt, {"cost_of_next", to.kind, "1", "timed"}, next.cost / r.cost, next.low / r.high, next.high / r.low);
    ratio.set_over(to.place());
    ratio.status = fmt::format("{}: {}", *ratio.low <= 1 ? "tied with" : "next", next.scheme);
    of_scheme.row(std::move(ratio));
  }
}

/// Of a scheme that has errors of this kind, but none as small.
void report_not_reached(const aim& to, recorder record) {
  const auto of = cost_quantity("cost_to_reach", to.kind);
  record.row({.quantity = of.name,
              .observable = of.observable,
              .unit = of.unit,
              .method = of.method,
              .status = "not reached at the finest dt measured",
              .at = {to.place()},
              .over = to.place().name});
}

void report_table(const context& c, const error_kind& kind, const std::vector<cost_point>& points,
                  const recorder& record) {
  for (int power = 1; power <= finest_accuracy; ++power) {
    const aim to{kind.name, 1 / std::pow(10.0, power)};
    const auto ranked = ranking(points, to.accuracy);
    if (ranked.empty()) {
      if (power == 1) continue;
      break;  // nor is anything finer reached
    }
    report_ranking(to, ranked, record);
    for (const auto& e : c.subject.schemes) {
      const auto& name = e.info.name;
      if (std::ranges::find(ranked, name, &reached::scheme) != ranked.end()) continue;
      if (std::ranges::find(points, name, &cost_point::scheme) == points.end()) continue;
      report_not_reached(to, record.of(name));
    }
  }
}

/// Kinds without errors: their experiment was not asked for, or could not say anything.
void report_missing(const context& c, const std::vector<error_kind>& kinds, report::results& out) {
  std::vector<std::string> wanted, names;
  for (const auto& k : kinds) {
    if (!k.errors.empty()) continue;
    const auto ran = [&](const report::experiment& e) { return e.name == k.source; };
    if (std::ranges::any_of(c.before->experiments, ran)) {
      out.savings.push_back({"work_precision",
                             "",
                             fmt::format("cost against {} error", k.name),
                             fmt::format("experiment {} found no such error on this scene", k.source),
                             {}});
      continue;
    }
    wanted.push_back(k.source);
    names.push_back(k.name);
  }
  if (!wanted.empty())
    out.skipped.push_back({"work_precision", "",
                           fmt::format("cost against {} error: run with --experiments {},work_precision for its errors",
                                       fmt::join(names, ", "), fmt::join(wanted, ","))});
}

void run(const context& c, report::results& out) {
  if (!c.before) return;
  const auto kinds = known_errors(c);
  price_list prices(c);
  for (const auto& kind : kinds)
    for (const auto& e : kind.errors) prices.want(e.scheme, e.dt, kind.silent);
  prices.measure();
  recorder record("work_precision", "", out);
  const auto& yard = prices.yardstick();
  if (yard.ns > 0) record.value({"yardstick", "", "ns per path-step", "timed"}, yard.ns, yard.low, yard.high);
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    auto points = priced(kinds[k], prices, record);
    mark_front(points);
    report_points(kinds[k], points, record);
    report_table(c, kinds[k], points, record);
    c.progress(static_cast<double>(k + 1) / static_cast<double>(kinds.size()));
  }
  report_missing(c, kinds, out);
}

expected_work work_of(const subject& s, effort) { return {1e5, s.sphere() ? by_sphere(s, 0.2, 2, 1) : 0.05}; }

}  // namespace

experiment work_precision_experiment() {
  experiment e{
      {"work_precision",
       "What does an accuracy cost, and with which scheme is it cheapest?",
       {"Cost: CPU time of one thread on this machine in this run, of the pack kernels with independent noise (fast "
        "normals), per path and unit of time. Nine slots that lie apart, all steps in turn; in a slot the quicker of "
        "two runs of 16,384 path-steps (4096 in a field; of n > 3 components 440,000/n^3, but at least 1024), against "
        "a loop that never "
        "changes and is timed before and after it (the "
        "yardstick, in whose time ns are counted): the median over the slots and its 96 % interval. Never taken from "
        "an earlier run; no verdict rests on it.",
        "Free of the machine: steps and standard normals per path and unit of time.",
        "Errors are those found by the experiments strong, weak, gibbs (bias of all means), energy (law) and casimir "
        "of this run, in units of |Pi_0|, of the observable's root mean square over the sphere, of h_0, and relative; "
        "of several observables the worst. Of schemes that keep the sphere weak and stationary errors are those of the "
        "goals of select (at every step up to the horizon; at equilibrium), at longer steps too, and between two steps "
        "where the error hardly falls from one to the other. Off the sphere the weak error is that "
        "of all observables together, as sampled by experiment weak at the time that it says; of stationary laws no "
        "error over dt is sampled (select --goal stationary does that). The energy law is found without noise, and "
        "priced "
        "without. Schemes that keep the Casimirs are run here over the same levels, 64 paths each.",
        "On the Pareto front: no other point is as cheap and as accurate, and better in one of the two. A point whose "
        "error is not clear of its uncertainty is neither on the front nor beats anything.",
        "To reach an accuracy: the longest dt from which on down all measured errors are within it, by a power law "
        "between two measured levels; nothing is extrapolated beyond them. Tied: the ranges of the ratio reach 1.",
        "Combinations over step sizes pay for all their runs and stand at the coarsest dt. A step may cost more at a "
        "long dt, where rotations need longer polynomials: costs between two levels are of the same power law."}},
      work_of,
      [](const subject&) -> std::optional<std::string> { return std::nullopt; },
      run,
      extrapolated_names()};
  e.kept = false;
  return e;
}

}  // namespace polhode
