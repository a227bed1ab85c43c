#include "experiments/transfer_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ensemble/paths.hpp"
#include "experiments/progress_counter.hpp"

namespace polhode {
namespace {

constexpr double clear = 50;  // times its uncertainty: an error that a fit may use
constexpr double negligible_error = 1e-9;

struct column_fit {
  std::string observable;
  order_fit fit;
};

/// NaN where the error is not clear of its uncertainty.
std::vector<double> clear_errors(const error_table& t, Eigen::Index column) {
  std::vector<double> out;
  for (std::size_t i = 0; i < t.dt.size(); ++i) {
    const double error = std::fabs(t.error[i][column]);
    out.push_back(error >= clear * t.uncertainty[i][column] ? error : std::numeric_limits<double>::quiet_NaN());
  }
  return out;
}

std::vector<report::measurement> levels_of(const series& s, const error_table& t, Eigen::Index column) {
  std::vector<report::measurement> out;
  for (std::size_t i = 0; i < t.dt.size(); ++i) {
    const double error = std::fabs(t.error[i][column]), u = t.uncertainty[i][column];
    out.push_back(measured(s, t.dt[i], error, std::max(0.0, error - u), error + u));
  }
  return out;
}

const column_fit* slowest(const std::vector<column_fit>& fits) {
  const column_fit* out = nullptr;
  const auto later = [&](const column_fit& f) {
    if (!out || f.fit.settled != out->fit.settled) return !out || f.fit.settled;
    return f.fit.order < out->fit.order;
  };
  for (const auto& f : fits)
    if (later(f)) out = &f;
  return out;
}

bool has_value(const std::optional<order_fit>& fit) { return fit.has_value(); }

/// A fit a column; empty where it has fewer than four clear levels.
std::vector<std::optional<order_fit>> fits_of(const error_table& t, std::size_t columns) {
  std::vector<std::optional<order_fit>> out;
  for (std::size_t k = 0; k < columns; ++k)
    out.push_back(fit_order(t.dt, clear_errors(t, static_cast<Eigen::Index>(k)), 0));
  return out;
}

/// Of the columns' scales; not finite where an error is not.
double largest_error(const error_table& t, const std::vector<error_column>& columns) {
  double largest = 0;
  for (std::size_t i = 0; i < t.dt.size(); ++i)
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const auto column = static_cast<Eigen::Index>(k);
      const double most = (std::fabs(t.error[i][column]) + t.uncertainty[i][column]) / columns[k].scale;
      largest = std::isfinite(most) ? std::max(largest, most) : most;
    }
  return largest;
}

report::verdict without_fit(const claim& c, double expected, double largest) {
  report::verdict v{c.experiment, c.scheme, c.text, expected, {}, {}, {}, report::verdict_kind::inconclusive, ""};
  if (!std::isfinite(largest)) {
    v.reason = "not finite: a step of the scheme fails";
  } else if (largest < negligible_error) {
    v.kind = report::verdict_kind::holds;
    v.reason = fmt::format("no error: at most {:.1e} of the observables' size at every dt", largest);
  } else {
    v.reason = fmt::format("not resolved: fewer than four levels with an error of {:g} times its uncertainty", clear);
  }
  return v;
}

report::verdict judge(const order_question& q, double expected, const error_table& t,
                      const std::vector<std::optional<order_fit>>& fits) {
  if (std::ranges::none_of(fits, has_value))
    return without_fit({q.experiment, t.scheme, q.claim}, expected, largest_error(t, q.columns));
  return judge_columns(q, expected, t.scheme, fits);
}

/// There is a slope, but it says nothing yet.
bool unsettled(const order_question& q, double expected, const error_table& t) {
  const auto fits = fits_of(t, q.columns.size());
  return std::ranges::any_of(fits, has_value) && judge(q, expected, t, fits).kind == report::verdict_kind::inconclusive;
}

}  // namespace

double size_on_sphere(const sphere_function& f, double radius) {
  const auto rule = sphere_quadrature(30);
  double square = 0, area = 0;
  for (Eigen::Index i = 0; i < rule.weights.size(); ++i) {
    const double value = f(radius * rule.points.row(i).transpose());
    square += rule.weights[i] * value * value;
    area += rule.weights[i];
  }
  return std::sqrt(square / area);
}

report::verdict judge_columns(const order_question& q, double expected, const std::string& scheme,
                              const std::vector<std::optional<order_fit>>& found) {
  std::vector<column_fit> fits;
  for (std::size_t k = 0; k < found.size(); ++k)
    if (found[k]) fits.push_back({q.columns[k].observable, *found[k]});
  const claim c{q.experiment, scheme, q.claim};
  if (fits.empty()) return judge_order(c, expected, std::nullopt, true);
  const auto* deciding = slowest(fits);
  auto v = judge_order(c, expected, deciding->fit, true);
  v.reason += fmt::format("; {} decides, the slowest of {}", deciding->observable, fits.size());
  return v;
}

void error_table::add(double step, const transfer_answer& answer) {
  dt.push_back(step);
  error.push_back(answer.error);
  uncertainty.push_back(answer.uncertainty);
}

double weak_order_on(const scheme_info& info, noise_class noise) {
  const auto& w = info.weak_order;
  return noise == noise_class::one_vector ? w.one_vector : noise == noise_class::isotropic ? w.isotropic : w.general;
}

std::vector<error_table> answer_all(const context& c, const std::vector<scheme_entry>& schemes, const level_grid& grid,
                                    const order_question& q) {
  struct task {
    std::size_t scheme;
    std::int64_t steps;
  };
  std::vector<error_table> out(schemes.size());
  const auto answer = [&](const std::vector<task>& tasks, const std::function<void(double)>& progress) {
    std::vector<transfer_answer> answers(tasks.size());
    progress_counter done(static_cast<int>(tasks.size()), progress);
    const auto step = [&](const task& t) { return grid.horizon / static_cast<double>(t.steps); };
    parallel_for(c.threads, static_cast<int>(tasks.size()), [&](int i) {
      const auto& t = tasks[static_cast<std::size_t>(i)];
      const auto& scheme = schemes[t.scheme];
      answers[static_cast<std::size_t>(i)] = q.answer(scheme, step(t), t.steps);
      done.add();
    });
    for (std::size_t i = 0; i < tasks.size(); ++i) out[tasks[i].scheme].add(step(tasks[i]), answers[i]);
  };
  std::vector<task> tasks;
  for (std::size_t k = 0; k < schemes.size(); ++k) {
    out[k].scheme = schemes[k].info.name;
    for (const int steps : grid.steps) tasks.push_back({k, steps});
  }
  answer(tasks, c.progress);
  std::int64_t steps = grid.steps.back();
  for (int i = 0; i < most_halvings; ++i) {
    std::erase_if(tasks, [&](const task& t) {
      return t.steps != steps || !unsettled(q, q.expected(schemes[t.scheme]), out[t.scheme]);
    });
    steps *= 2;
    for (auto& t : tasks) t.steps = steps;
    answer(tasks, [](double) {});
  }
  return out;
}

void report_errors(const order_question& q, const error_table& t, report::results& out) {
  const auto fits = fits_of(t, q.columns.size());
  for (std::size_t k = 0; k < q.columns.size(); ++k) {
    const series s{q.experiment, t.scheme, q.columns[k].quantity, q.columns[k].observable, "", "transfer"};
    record_fit(out, s, fits[k], levels_of(s, t, static_cast<Eigen::Index>(k)));
  }
}

void report_orders(const order_question& q, double expected, const error_table& t, report::results& out) {
  report_errors(q, t, out);
  out.verdicts.push_back(judge_table(q, expected, t));
}

report::verdict judge_table(const order_question& q, double expected, const error_table& t) {
  return judge(q, expected, t, fits_of(t, q.columns.size()));
}

bool unresolved(const error_table& t, const std::vector<error_column>& columns) {
  const auto fits = fits_of(t, columns.size());
  const double largest = largest_error(t, columns);
  return std::isfinite(largest) && largest >= negligible_error && std::ranges::none_of(fits, has_value);
}

}  // namespace polhode
