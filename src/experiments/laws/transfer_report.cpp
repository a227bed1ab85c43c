// SPDX-License-Identifier: Apache-2.0
#include "experiments/laws/transfer_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/progress_counter.hpp"
#include "experiments/laws/transfer_verdict.hpp"

namespace polhode {
namespace {

curve errors_of(const error_column& what, const error_table& t, Eigen::Index column) {
  curve out{{what.quantity, what.observable, "", "transfer"}};
  for (std::size_t i = 0; i < t.dt.size(); ++i) {
    const double error = std::fabs(t.error[i][column]), u = t.uncertainty[i][column];
    out.add(t.dt[i], error, std::max(0.0, error - u), error + u);
  }
  return out;
}

/// In units of the observables' sizes; a change that is not a number is the largest.
double largest_change(const order_question& q, const Eigen::VectorXd& change) {
  double largest = 0;
  for (Eigen::Index k = 0; k < change.size(); ++k)
    if (const double share = change[k] / q.columns[static_cast<std::size_t>(k)].scale; !(share <= largest))
      largest = share;
  return largest;
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
  for (std::size_t k = 0; k < schemes.size(); ++k) out[k].scheme = schemes[k].info.name;
  for (const int steps : grid.steps)  // long ones, the dearest, first: no thread is left alone with one
    for (std::size_t k = 0; k < schemes.size(); ++k) tasks.push_back({k, steps});
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

std::vector<report::series_id> report_errors(const order_question& q, double expected, const error_table& t,
                                             recorder& record) {
  const auto found = find_columns(q, expected, t);
  std::vector<report::series_id> written;
  for (std::size_t k = 0; k < q.columns.size(); ++k) {
    const auto& name = q.columns[k].quantity;
    written.push_back(record.series(errors_of(q.columns[k], t, static_cast<Eigen::Index>(k)), found[k].fit));
    for (std::size_t power = 0; power < found[k].terms.size(); ++power) {
      const auto& term = found[k].terms[power];
      const auto what = power == 0 ? name + " at dt = 0" : fmt::format("coefficient of dt^{} in the {}", power, name);
      written.push_back(record.value({what, q.columns[k].observable, "", "transfer"}, term.value,
                                     term.value - term.certainty(), term.value + term.certainty()));
    }
  }
  return written;
}

std::vector<report::series_id> report_reach(const order_question& q, const error_table& t, recorder& record) {
  std::vector<report::series_id> written;
  if (std::ranges::any_of(t.taken_back, [](double share) { return share > 0; })) {
    curve shares{{"paths taken back to the shell", "", "share, at most", "transfer"}};
    for (std::size_t i = 0; i < t.taken_back.size(); ++i) shares.add(t.dt[i], t.taken_back[i]);
    written.push_back(record.series(shares));
  }
  if (t.far_noise.change.size() > 0)
    written.push_back(record.value({"largest change by noise far out", "", "size of the observable", "transfer"},
                                   at_dt(t.far_noise.dt), largest_change(q, t.far_noise.change)));
  return written;
}

std::vector<report::series_id> report_orders(const order_question& q, double expected, const error_table& t,
                                             recorder& record) {
  auto evidence = report_errors(q, expected, t, record);
  std::ranges::move(report_reach(q, t, record), std::back_inserter(evidence));
  record.verdict(q.claim, judge_table(q, expected, t), evidence);
  return evidence;
}

}  // namespace polhode
