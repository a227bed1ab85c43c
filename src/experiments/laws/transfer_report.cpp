#include "experiments/laws/transfer_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/progress_counter.hpp"
#include "experiments/laws/transfer_verdict.hpp"

namespace polhode {
namespace {

std::vector<report::measurement> levels_of(const series& s, const error_table& t, Eigen::Index column) {
  std::vector<report::measurement> out;
  for (std::size_t i = 0; i < t.dt.size(); ++i) {
    const double error = std::fabs(t.error[i][column]), u = t.uncertainty[i][column];
    out.push_back(measured(s, t.dt[i], error, std::max(0.0, error - u), error + u));
  }
  return out;
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

void error_table::add(double step, const transfer_answer& answer) {
  dt.push_back(step);
  error.push_back(answer.error);
  uncertainty.push_back(answer.uncertainty);
  taken_back.push_back(answer.taken_back);
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
      return t.steps != steps || !too_wide(q, q.expected(schemes[t.scheme]), out[t.scheme]);
    });
    steps *= 2;
    for (auto& t : tasks) t.steps = steps;
    answer(tasks, [](double) {});
  }
  if (q.far_noise)
    parallel_for(c.threads, static_cast<int>(schemes.size()), [&](int i) {
      const auto k = static_cast<std::size_t>(i);
      const double dt = grid.horizon / grid.steps.back();
      out[k].far_noise = {dt, rare_share(c.subject.model->layout().active),
                          q.far_noise(schemes[k], dt, grid.steps.back())};
    });
  return out;
}

void report_errors(const order_question& q, double expected, const error_table& t, report::results& out) {
  const auto found = find_columns(q, expected, t);
  for (std::size_t k = 0; k < q.columns.size(); ++k) {
    series s{q.experiment, t.scheme, q.columns[k].quantity, q.columns[k].observable, "", "transfer"};
    record_fit(out, s, found[k].fit, levels_of(s, t, static_cast<Eigen::Index>(k)));
    for (std::size_t power = 0; power < found[k].terms.size(); ++power) {
      const auto& term = found[k].terms[power];
      s.quantity = power == 0 ? q.columns[k].quantity + " at dt = 0"
                              : fmt::format("coefficient of dt^{} in the {}", power, q.columns[k].quantity);
      out.measurements.push_back(
          measured(s, {}, term.value, term.value - term.certainty(), term.value + term.certainty()));
    }
  }
}

void report_reach(const order_question& q, const error_table& t, report::results& out) {
  series s{q.experiment, t.scheme, "paths taken back to the shell", "", "share, at most", "transfer"};
  if (std::ranges::any_of(t.taken_back, [](double share) { return share > 0; }))
    for (std::size_t i = 0; i < t.taken_back.size(); ++i)
      out.measurements.push_back(measured(s, t.dt[i], t.taken_back[i]));
  if (t.far_noise.change.size() == 0) return;
  double largest = 0;
  for (Eigen::Index k = 0; k < t.far_noise.change.size(); ++k)
    if (const double change = t.far_noise.change[k] / q.columns[static_cast<std::size_t>(k)].scale;
        !(change <= largest))
      largest = change;  // also what is not a number
  s.quantity = "largest change by noise far out";
  s.unit = "size of the observable";
  out.measurements.push_back(measured(s, t.far_noise.dt, largest));
}

void report_orders(const order_question& q, double expected, const error_table& t, report::results& out) {
  report_errors(q, expected, t, out);
  report_reach(q, t, out);
  out.verdicts.push_back(judge_table(q, expected, t));
}

}  // namespace polhode
