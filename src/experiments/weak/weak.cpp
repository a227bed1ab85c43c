// SPDX-License-Identifier: Apache-2.0
// How far is the law of a scheme from the true law after the scene's horizon, and how fast does that fall?
//
// On a sphere both expectations are linear algebra: the scheme's by its transfer operator (transfer.hpp), the true one
// by the Kolmogorov operator (sphere/expectations/expectation.hpp). Elsewhere their difference is sampled
// (weak_sampled.hpp).
#include <fmt/format.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/common/operator_work.hpp"
#include "experiments/common/undecided.hpp"
#include "experiments/laws/extrapolation.hpp"
#include "experiments/laws/law_errors.hpp"
#include "experiments/weak/true_means.hpp"
#include "experiments/weak/weak_course.hpp"
#include "experiments/weak/weak_sampled.hpp"

namespace polhode {
namespace {

// The errors of schemes' laws at the horizon and at all times up to it, on one grid of steps, and what is said of them.

/// Every scheme's errors on one grid of steps.
class weak_tables {
 public:
  weak_tables(const context&, const true_means&, std::vector<scheme_entry>, level_grid);
  weak_tables(const weak_tables&) = delete;
  weak_tables& operator=(const weak_tables&) = delete;

  /// All but the schemes that are not resolved, which it returns.
  std::vector<scheme_entry> report(const subject&, report::results& out) const;

  order_question question(const subject&) const;

  const std::vector<scheme_entry> schemes;

 private:
  void report_one(const subject&, const scheme_entry&, const error_table&, report::results& out) const;
  void report_extrapolations(const order_question&, const error_table&, double horizon, report::results& out) const;
  void report_cost(const error_table&, double horizon, double order, double runs, recorder&) const;

  const true_means& known_;
  level_grid grid_;
  weak_course course_;
  std::vector<error_table> tables_;
};

constexpr double course_accuracy = 1e-12;  // of an observable's size, at every time
constexpr double tolerance = 5e-4, extrapolated_tolerance = 1e-7;
constexpr std::int64_t fitted_range = 64;  // a fit takes the six finest levels, and halving one more
constexpr std::string_view beside = "strang";

weak_tables::weak_tables(const context& c, const true_means& t, std::vector<scheme_entry> asked, level_grid levels)
    : schemes(std::move(asked)),
      known_(t),
      grid_(std::move(levels)),
      course_(c.subject, t.columns, t.functions, grid_, course_accuracy) {
  auto at_all_times = question(c.subject);
  at_all_times.columns = course_.decisive();
  tables_ = answer_all(c, schemes, grid_, at_all_times);
  const auto count = static_cast<Eigen::Index>(t.columns.size());
  for (auto& table : tables_)
    for (auto& u : table.uncertainty) u.head(count) += Eigen::Map<const Eigen::VectorXd>(t.uncertainty.data(), count);
}

std::vector<scheme_entry> weak_tables::report(const subject& s, report::results& out) const {
  std::vector<scheme_entry> left;
  for (std::size_t k = 0; k < tables_.size(); ++k)
    if (unresolved(tables_[k], known_.columns))
      left.push_back(schemes[k]);
    else
      report_one(s, schemes[k], tables_[k], out);
  return left;
}

order_question weak_tables::question(const subject& s) const {
  return {"weak",
          weak_order_claim,
          known_.columns,
          [noise = s.model->noise()](const scheme_entry& e) { return weak_order_on(e.info, noise); },
          [this, &s](const scheme_entry& e, double dt, std::int64_t steps) {
            const bool fitted = steps * fitted_range >= grid_.steps.back();
            const bool tight = fitted && e.info.name == extrapolated_from;
            return course_.answer(s, e, dt, steps, known_.target(tight ? extrapolated_tolerance : tolerance));
          },
          [this, &s](const scheme_entry& e, double dt, std::int64_t steps) {
            return change_by_far_noise(s, e, dt, steps, [&](const transfer_operator& op) -> Eigen::VectorXd {
              return means_after(op, start_of(s), known_.functions, {steps});
            });
          }};
}

void weak_tables::report_one(const subject& s, const scheme_entry& scheme, const error_table& table,
                             report::results& out) const {
  const auto q = question(s);
  const double expected = weak_order_on(scheme.info, s.model->noise()), horizon = s.scene.horizon;
  const auto name = scheme.info.name;
  recorder record("weak", name, out);
  const auto at_end = report_orders(q, expected, table, record);
  if (course_.reason().empty())
    course_.report(q, expected, table, at_end, record);
  else
    record.verdict(weak_course::claim, {.reason = "the true means at all times are " + course_.reason()});
  if (name == extrapolated_from || name == beside) report_cost(table, horizon, expected, 1, record);
  if (name == extrapolated_from) report_extrapolations(q, table, horizon, out);
}

/// Where strang's, strang_two_turns' and the combinations' accuracy comes from, in steps.
void weak_tables::report_cost(const error_table& t, double horizon, double order, double runs, recorder& record) const {
  for (const double accuracy : {1e-4, 1e-6, 1e-8})
    record.value({"steps for an error", fmt::format("{:g}", accuracy), "steps", "transfer"},
                 steps_for(t, known_.columns, horizon, accuracy, order, runs));
}

void weak_tables::report_extrapolations(const order_question& q, const error_table& t, double horizon,
                                        report::results& out) const {
  for (const auto& e : extrapolations) {
    const auto combined = extrapolate(t, e);
    if (combined.dt.empty()) continue;
    recorder record("weak", e.name, out);
    const auto evidence = report_errors(q, e.order, combined, record);
    if (unresolved(combined, known_.columns))
      out.skipped.push_back({"weak", std::string(e.name),
                             "fewer than four levels lie clear of rounding and of what the operators leave uncertain"});
    else
      record.verdict(q.claim, judge_table(q, e.order, combined), evidence);
    report_cost(combined, horizon, e.order, e.runs(), record);
  }
}

constexpr std::size_t sampled_components = 6;  // of a long state

/// Two levels more, for schemes of which too many coarse ones run off the shell.
level_grid with_finer(level_grid grid) {
  for (int i = 0; i < 2; ++i) grid.steps.push_back(2 * grid.steps.back());
  return grid;
}

std::function<double(const scheme_entry&)> claimed_on(const subject& s) {
  return [noise = s.model->noise()](const scheme_entry& e) { return weak_order_on(e.info, noise); };
}

/// Of schemes of which no operator is resolved.
void report_unresolved(const context& c, const std::vector<scheme_entry>& schemes, report::results& out) {
  leave_open(schemes, "weak", weak_course::claim, "no operator is resolved, and only the end point is sampled", out);
  std::vector<observable> observables;
  for (const char* name : weak_observables) observables.push_back({name, *observable_of(c.subject, name)});
  report_sampled_orders(c, schemes, observables, claimed_on(c.subject), out);
}

void report_on_the_sphere(const context& c, report::results& out) {
  const auto& s = c.subject;
  const auto t = true_means_of(s, out);
  const auto grid = scene_levels(s);
  const weak_tables all(c, t, t.columns.empty() ? std::vector<scheme_entry>{} : s.schemes, grid);
  auto left = t.columns.empty() ? s.schemes : all.report(s, out);
  if (!left.empty() && !t.columns.empty()) left = weak_tables(c, t, left, with_finer(grid)).report(s, out);
  if (!left.empty()) report_unresolved(c, left, out);
}

void run(const context& c, report::results& out) {
  if (c.subject.sphere()) return report_on_the_sphere(c, out);
  out.skipped.push_back(
      {"weak", "", fmt::format("{}: errors are sampled, at the end point alone", weak_course::claim)});
  report_sampled_orders(c, c.subject.schemes, observables_of(c.subject, sampled_components), claimed_on(c.subject),
                        out);
}

std::optional<std::string> skip_reason(const subject& s) {
  if (s.model->noise() == noise_class::none)
    return "no noise: the error of the law is that of the path (experiment energy)";
  return s.sphere() ? beyond_reach(s) : std::nullopt;
}

expected_work work_of(const subject& s, effort e) {
  if (s.sphere()) return {by_effort(e, 3.5e6, 5e6, 1e7), by_sphere(s, 0.3, 1.2, 2)};
  return {by_effort(e, 7e6, 1.2e7, 2e7), 0};
}

}  // namespace

experiment weak_experiment() {
  return {
      {"weak",
       "How far is E[f(Pi_T)] of the scheme from the true one, and how fast does that fall?",
       {"On a sphere of momentum nothing is sampled: one step's expectation by Gauss-Hermite quadrature over its "
        "noise, projected on spherical harmonics (for schemes that leave the sphere: times Chebyshev polynomials of "
        "the radius, on a shell of some standard deviations of it; paths that run far beyond are taken back to it); "
        "its powers against the exponential of the Kolmogorov operator.",
        fmt::format(
            "On other systems, and where an operator is not resolved at an affordable degree, the order is sampled: "
            "E[f(X_dt) - f(X)] of paths that share their noise with the driven equation X, its bias taken out to "
            "second order of its step, of the energy, the components (the first {}) and their squares. Areas that a "
            "scheme does not see are averaged over both orders of the increments that make them (Giles and Szpruch "
            "2014), and what total increments explain is taken out by regression. A level counts where its error is "
            "five times the sampling error. The order is that of all observables added up in the direction of their "
            "errors (all, in their sizes); it decides nothing while its interval is wider than {:g}.",
            sampled_components, order_margin),
        "On a product of two spheres (so(4), two spins) the true means are exact, on products of harmonics. X is held "
        "to "
        "them, a z-value an observable; beyond a false alarm of one in a million nothing is concluded. Error against "
        "the true mean, of the energy: E[f(X_dt) - f(X)] + E[f(X)] less the exact mean.",
        "Intervals on a sphere: the change at the last refinement of degree, quadrature and shell, and the "
        "reference's own. A fit uses errors of at least fifty times that.",
        "These errors are a power series a_0 + a_1 dt + … (Talay and Tubaro 1990), whose terms the levels tell with a "
        "certainty: what their uncertainties add up to at worst, and what changes with the degree of the polynomial "
        "and with its levels. Weak order p: of every observable a_0 … a_(p-1) vanish within that, and the slope "
        "between the two finest levels is not below p. a_0 is zero if its interval meets what 0.01 % of noise or of "
        "dissipation would move; unless 0.1 % of either would be seen, nothing is concluded.",
        "Schemes that leave the sphere: the drift is cubic and the noise normal, so that moments of all paths need "
        "not exist. The claim is about the paths that stay (Milstein and Tretyakov 2005: rejected trajectories); a "
        "bound on the share of the others is listed and part of the uncertainty.",
        "Quadrature over few nodes takes a step to be smooth in its increment. At one level it is checked against "
        "nodes out to 8 sqrt(dt); where these move the law, the verdict is refuted.",
        "strang_extrapolated: (4 E_2n - E_n)/3 of strang_two_turns (Talay and Tubaro 1990), listed at the coarsest "
        "dt, at the cost of 3n steps; of order three, its dt^3 being so small that dt^4 is seen first. "
        "strang_extrapolated5: runs of n, 2n, 4n and 8n steps, 15n in all, without dt^2, dt^3 and dt^4; dt^6 is seen "
        "first. Steps for an error: of the worst observable, in units of its size.",
        fmt::format("While intervals of exact errors are too wide for a verdict dt is halved on, {} times at most.",
                    most_halvings),
        "Areas of transfer operators are drawn from the weak surrogate (independent normals of variance dt^2/4); "
        "those of "
        "sampled paths are the path's own."}},
      work_of,
      skip_reason,
      run,
      extrapolated_names()};
}

}  // namespace polhode
