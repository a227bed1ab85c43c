// SPDX-License-Identifier: Apache-2.0
#include "experiments/laws/stationary_bias.hpp"

#include <optional>
#include <string>

#include "experiments/common/undecided.hpp"
#include "experiments/laws/bias_reference.hpp"
#include "experiments/laws/transfer_report.hpp"
#include "experiments/laws/true_law.hpp"
#include "sphere/uniqueness.hpp"

namespace polhode {
namespace {

constexpr const char* bias_claim = "order of the stationary bias";

}  // namespace

void report_stationary_bias(const context& c, report::results& out) {
  const auto& s = c.subject;
  const auto& problem = s.sphere();
  if (!problem) {
    out.skipped.push_back({"gibbs", "", std::string("bias by transfer operators: ") + no_exact_law});
    return;
  }
  if (const auto reason = no_unique_law(*problem); !reason.empty()) {
    out.skipped.push_back({"gibbs", "", "bias by transfer operators: the true stationary law is " + reason});
    return;
  }
  std::vector<scheme_entry> schemes;
  for (const auto& e : s.schemes)
    if (e.info.casimir.exact) schemes.push_back(e);
  const auto law = true_law(s);
  std::string reason;
  const auto reference = is_usable(law) ? std::optional(bias_by_density(s, law)) : bias_by_difference(s, law, reason);
  if (!reference) {
    leave_open(schemes, "gibbs", bias_claim, "the true stationary mean of h is " + reason, out);
    return;
  }
  const auto expected = [&](const scheme_entry& e) { return weak_order_on(e.info, s.model->noise()); };
  const order_question q{
      "gibbs",
      bias_claim,
      reference->columns,
      expected,
      [&](const scheme_entry& e, double dt, std::int64_t steps) { return reference->of(s, e, dt, steps); },
      [&](const scheme_entry& e, double dt, std::int64_t steps) {
        return reference->change_by_far_noise(s, e, dt, steps);
      }};
  const auto tables = answer_all(c, schemes, scene_levels(s), q);
  for (std::size_t k = 0; k < tables.size(); ++k) {
    recorder record(q.experiment, tables[k].scheme, out);
    report_orders(q, expected(schemes[k]), tables[k], record);
  }
}

}  // namespace polhode
