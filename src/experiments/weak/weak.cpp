// How far is the law of a scheme from the true law after the scene's horizon, and how fast does that fall?
//
// Both expectations are linear algebra: the scheme's by its transfer operator (transfer.hpp), the true one by the
// Kolmogorov operator (sphere/kolmogorov.hpp). Nothing is sampled.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/common/undecided.hpp"
#include "experiments/laws/extrapolation.hpp"
#include "experiments/laws/law_errors.hpp"
#include "experiments/weak/weak_course.hpp"
#include "experiments/weak/weak_sampled.hpp"

namespace polhode {
namespace {

constexpr std::array observables{"energy", "pi1", "pi2", "pi3", "pi1^2", "pi2^2", "pi3^2", "exp(pi3)"};
constexpr double reference_accuracy = 1e-13;  // of an observable's size
constexpr double course_accuracy = 1e-12;     // likewise, at every time
constexpr double usable = 1e-7;               // of it: where that accuracy is out of reach
constexpr double tolerance = 5e-4, extrapolated_tolerance = 1e-7;
constexpr std::int64_t fitted_range = 64;  // a fit takes the six finest levels, and halving one more
constexpr std::string_view beside = "strang";

/// Observables whose true expectation is known.
struct truths {
  std::vector<error_column> columns;
  std::vector<sphere_function> functions;
  std::vector<double> exact, uncertainty;
};

Eigen::Vector3d start_of(const subject& s) { return Eigen::Map<const Eigen::Vector3d>(s.scene.momentum.data()); }

/// The column of f, whose true expectation is `exact`, with what moves it: difference quotients, no better than their
/// share need be.
error_column column_of(const subject& s, const sphere_problem& p, const char* name, const sphere_function& f,
                       double scale, double exact) {
  constexpr double accuracy = 1e-8;
  const auto moved = [&](const sphere_problem& other) {
    const auto value = expectation(other, f, start_of(s), s.scene.horizon, accuracy * scale);
    return value.value && value.uncertainty <= usable * scale ? (*value.value - exact) / sensitivity_share : 0;
  };
  return {"error", name, scale, moved(with_more_noise(p, sensitivity_share)),
          p.damping > 0 ? moved(with_more_dissipation(p, sensitivity_share)) : 0};
}

truths true_expectations(const subject& s, report::results& out) {
  const auto problem = *s.sphere();
  truths t;
  for (const char* name : observables) {
    const auto f = *named_observable(name, problem);
    const double scale = size_on_sphere(f, problem.radius);
    const auto value = expectation(problem, f, start_of(s), s.scene.horizon, reference_accuracy * scale);
    if (!value.value || value.uncertainty > usable * scale) {
      leave_open(s.schemes, "weak", fmt::format("weak order of E[{}]", name), "its true value is " + value.reason, out);
      continue;
    }
    t.columns.push_back(column_of(s, problem, name, f, scale, *value.value));
    t.functions.push_back(f);
    t.exact.push_back(*value.value);
    t.uncertainty.push_back(value.uncertainty);
  }
  return t;
}

transfer_target target_on(const truths& t, double accuracy) {
  const auto count = static_cast<Eigen::Index>(t.columns.size());
  return {
      Eigen::Map<const Eigen::VectorXd>(t.exact.data(), count),
      Eigen::VectorXd::NullaryExpr(count, [&](Eigen::Index i) { return t.columns[static_cast<std::size_t>(i)].scale; }),
      accuracy};
}

/// Where strang's, strang_two_turns' and the combinations' accuracy comes from, in steps.
void report_cost(const error_table& t, const truths& known, double horizon, double order, double runs,
                 report::results& out) {
  for (const double accuracy : {1e-4, 1e-6, 1e-8}) {
    const series s{"weak", t.scheme, "steps for an error", fmt::format("{:g}", accuracy), "steps", "transfer"};
    out.measurements.push_back(measured(s, {}, steps_for(t, known.columns, horizon, accuracy, order, runs), {}, {}));
  }
}

void report_extrapolations(const order_question& q, const error_table& t, const truths& known, double horizon,
                           report::results& out) {
  for (const auto& e : extrapolations) {
    const auto combined = extrapolate(t, e);
    if (combined.dt.empty()) continue;
    report_errors(q, e.order, combined, out);
    if (unresolved(combined, known.columns))
      out.skipped.push_back({"weak", std::string(e.name),
                             "fewer than four levels lie clear of rounding and of what the operators leave uncertain"});
    else
      out.verdicts.push_back(judge_table(q, e.order, combined));
    report_cost(combined, known, horizon, e.order, e.runs(), out);
  }
}

/// Every scheme's errors on one grid of steps.
class weak_tables {
 public:
  weak_tables(const context& c, const truths& t, std::vector<scheme_entry> asked, level_grid levels)
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
  weak_tables(const weak_tables&) = delete;
  weak_tables& operator=(const weak_tables&) = delete;

  /// All but the schemes that are not resolved, which it returns.
  std::vector<scheme_entry> report(const subject& s, report::results& out) const {
    std::vector<scheme_entry> left;
    for (std::size_t k = 0; k < tables_.size(); ++k)
      if (unresolved(tables_[k], known_.columns))
        left.push_back(schemes[k]);
      else
        report_one(s, schemes[k], tables_[k], out);
    return left;
  }

  order_question question(const subject& s) const {
    return {"weak",
            "weak order",
            known_.columns,
            [noise = s.model->noise()](const scheme_entry& e) { return weak_order_on(e.info, noise); },
            [this, &s](const scheme_entry& e, double dt, std::int64_t steps) {
              const bool fitted = steps * fitted_range >= grid_.steps.back();
              const bool tight = fitted && e.info.name == extrapolated_from;
              return course_.answer(s, e, dt, steps, target_on(known_, tight ? extrapolated_tolerance : tolerance));
            },
            [this, &s](const scheme_entry& e, double dt, std::int64_t steps) {
              return change_by_far_noise(s, e, dt, steps, [&](const transfer_operator& op) -> Eigen::VectorXd {
                return means_after(op, start_of(s), known_.functions, {steps});
              });
            }};
  }

  const std::vector<scheme_entry> schemes;

 private:
  void report_one(const subject& s, const scheme_entry& scheme, const error_table& table, report::results& out) const {
    const auto q = question(s);
    const double expected = weak_order_on(scheme.info, s.model->noise());
    const auto name = scheme.info.name;
    report_orders(q, expected, table, out);
    if (course_.reason().empty())
      course_.report(q, expected, table, out);
    else
      leave_open({&scheme, 1}, "weak", weak_course::claim, "the true means at all times are " + course_.reason(), out);
    if (name == extrapolated_from || name == beside) report_cost(table, known_, s.scene.horizon, expected, 1, out);
    if (name == extrapolated_from) report_extrapolations(q, table, known_, s.scene.horizon, out);
  }

  const truths& known_;
  level_grid grid_;
  weak_course course_;
  std::vector<error_table> tables_;
};

/// Two levels more, for schemes of which too many coarse ones run off the shell.
level_grid with_finer(level_grid grid) {
  for (int i = 0; i < 2; ++i) grid.steps.push_back(2 * grid.steps.back());
  return grid;
}

/// Of schemes of which no operator is resolved.
void report_sampled(const context& c, const std::vector<scheme_entry>& schemes, order_question q,
                    report::results& out) {
  leave_open(schemes, "weak", weak_course::claim, "no operator is resolved, and only the end point is sampled", out);
  std::vector<sphere_function> functions;
  q.columns.clear();
  for (const char* name : observables) {
    q.columns.push_back({"difference", name, 1});
    functions.push_back(*named_observable(name, *c.subject.sphere()));
  }
  report_sampled_orders(c, schemes, q, functions, out);
}

void run(const context& c, report::results& out) {
  const auto& s = c.subject;
  const auto t = true_expectations(s, out);
  const auto grid = scene_levels(s);
  const weak_tables all(c, t, t.columns.empty() ? std::vector<scheme_entry>{} : s.schemes, grid);
  auto left = t.columns.empty() ? s.schemes : all.report(s, out);
  if (!left.empty() && !t.columns.empty()) left = weak_tables(c, t, left, with_finer(grid)).report(s, out);
  if (!left.empty()) report_sampled(c, left, all.question(s), out);
}

std::optional<std::string> cannot_say(const subject& s) {
  if (!s.sphere()) return no_exact_law;
  if (s.model->noise() == noise_class::none)
    return "no noise: the error of the law is that of the path (experiment energy)";
  return std::nullopt;
}

}  // namespace

experiment weak_experiment() {
  return {
      {"weak",
       "How far is E[f(Pi_T)] of the scheme from the true one, and how fast does that fall?",
       {"Nothing is sampled: one step's expectation by Gauss-Hermite quadrature over its noise, projected on "
        "spherical harmonics (for schemes that leave the sphere: times Chebyshev polynomials of the radius, on a "
        "shell of some standard deviations of it; paths that run far beyond are taken back to it); its powers "
        "against the exponential of the Kolmogorov operator.",
        "Intervals: the change at the last refinement of degree, quadrature and shell, and the reference's own. "
        "A fit uses errors of at least fifty times that.",
        "The errors are a power series a_0 + a_1 dt + … (Talay and Tubaro 1990), whose terms the levels tell with "
        "a certainty: what their uncertainties add up to at worst, and what changes with the degree of the "
        "polynomial and with its levels. Weak order p: of every observable a_0 … a_(p-1) vanish within that, and "
        "the slope between the two finest levels is not below p. a_0 is zero if its interval meets what 0.01 % of "
        "noise or of dissipation would move; unless 0.1 % of either would be seen, nothing is concluded.",
        "Schemes that leave the sphere: the drift is cubic and the noise normal, so that moments of all paths need "
        "not exist. The claim is about the paths that stay (Milstein and Tretyakov 2005: rejected trajectories); a "
        "bound on the share of the others is listed and part of the uncertainty.",
        "Quadrature over few nodes takes a step to be smooth in its increment. At one level it is checked against "
        "nodes out to 8 sqrt(dt); where these move the law, the verdict is refuted.",
        "strang_extrapolated: (4 E_2n - E_n)/3 of strang_two_turns (Talay and Tubaro 1990), listed at the coarsest dt, "
        "at the cost of 3n steps; of order three, its dt^3 being so small that dt^4 is seen first. "
        "strang_extrapolated5: runs of n, 2n, 4n and 8n steps, 15n in all, without dt^2, dt^3 and dt^4; dt^6 is "
        "seen first. Steps for an error: of the worst observable, in units of its size.",
        fmt::format(
            "While intervals are too wide for a verdict dt is halved on, {} times at most. Where an operator is not "
            "resolved at an affordable degree, the order is sampled: E[f(X_dt) - f(X)] of paths that "
            "share their noise with the driven equation, with its variance and the path-steps it took.",
            most_halvings),
        "Areas are drawn from the weak surrogate (independent normals of variance dt^2/4)."}},
      2,
      cannot_say,
      run,
      extrapolated_names()};
}

}  // namespace polhode
