// SPDX-License-Identifier: Apache-2.0
#include "experiments/lyapunov/discretisation_exponents.hpp"

#include "experiments/laws/transfer_report.hpp"

namespace polhode {
namespace {

constexpr double resolution = 32;         // of the finest level: a slope that is not asymptotic by then is followed on
constexpr double long_step = 0.3;         // times the fastest rate: fits seldom reach there, and operators are dearest
constexpr double least_tolerance = 1e-2;  // of an error, at such steps: half of what a fit asks for

/// By how much both exponents change with noise or dissipation, over the share by which that grows.
Eigen::Vector2d moved(const lyapunov_exponents& exact, const sphere_problem& other) {
  constexpr double accuracy = 1e-6;
  const auto found = lyapunov(other, accuracy);
  if (!found.reason.empty()) return Eigen::Vector2d::Zero();
  return Eigen::Vector2d(*found.lambda1 - *exact.lambda1, found.sum - exact.sum) / sensitivity_share;
}

}  // namespace

void report_discretisation_exponents(const context& c, const std::vector<scheme_entry>& schemes,
                                     const lyapunov_exponents& exact, report::results& out) {
  const auto& s = c.subject;
  const auto expected = [&](const scheme_entry& e) { return weak_order_on(e.info, s.model->noise()); };
  const double rate = fastest_rate(s);
  const double tolerance = by_effort(c.effort, 4e-3, 4e-3, 1e-3);  // of an error
  const auto target_at = [&](double dt) -> transfer_target {
    return {Eigen::Vector2d(*exact.lambda1, exact.sum), Eigen::Vector2d::Constant(rate),
            c.effort == effort::quick && dt * rate > long_step ? least_tolerance : tolerance};
  };
  const auto problem = *s.sphere();
  const Eigen::Vector2d noise = moved(exact, with_more_noise(problem, sensitivity_share)),
                        dissipation = moved(exact, with_more_dissipation(problem, sensitivity_share));
  const order_question q{
      "lyapunov",
      exponents_order_claim,
      {{"error", "lambda_1", rate, noise[0], dissipation[0]},
       {"error", "lambda_1 + lambda_2", rate, noise[1], dissipation[1]}},
      expected,
      [&](const scheme_entry& e, double dt, std::int64_t) { return refine_exponents(s, e, dt, target_at(dt)); }};
  auto tables = answer_all(c, schemes, asymptotic_levels(s, resolution), q);
  for (std::size_t k = 0; k < tables.size(); ++k) {
    recorder record(q.experiment, tables[k].scheme, out);
    for (auto& u : tables[k].uncertainty) u += Eigen::Vector2d(exact.uncertainty, exact.sum_uncertainty);
    report_orders(q, expected(schemes[k]), tables[k], record);
  }
}

}  // namespace polhode
