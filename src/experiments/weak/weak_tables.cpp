// SPDX-License-Identifier: Apache-2.0
#include "experiments/weak/weak_tables.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "experiments/common/undecided.hpp"
#include "experiments/laws/extrapolation.hpp"
#include "experiments/laws/law_errors.hpp"
#include "experiments/weak/weak_sampled.hpp"

namespace polhode {
namespace {

constexpr double course_accuracy = 1e-12;  // of an observable's size, at every time
constexpr double tolerance = 5e-4, extrapolated_tolerance = 1e-7;
constexpr std::int64_t fitted_range = 64;  // a fit takes the six finest levels, and halving one more
constexpr std::string_view beside = "strang";

}  // namespace

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

}  // namespace polhode
