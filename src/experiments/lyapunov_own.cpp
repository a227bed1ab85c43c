#include "experiments/lyapunov_own.hpp"

#include "experiments/transfer_report.hpp"

namespace polhode {
namespace {

constexpr double resolution = 32;  // of the finest level: a slope that has not settled by then is followed on

}  // namespace

void report_own_exponents(const context& c, const std::vector<scheme_entry>& schemes, const lyapunov_exponents& exact,
                          report::results& out) {
  const auto& s = c.subject;
  const auto expected = [&](const scheme_entry& e) { return weak_order_on(e.info, s.model->noise()); };
  const double rate = fastest_rate(s);
  const double tolerance = by_effort(c.effort, 1e-2, 4e-3, 1e-3);  // of an error
  const transfer_target target{Eigen::Vector2d(*exact.lambda1, exact.sum), Eigen::Vector2d::Constant(rate), tolerance};
  const order_question q{
      "lyapunov",
      own_order_claim,
      {{"error", "lambda_1", rate}, {"error", "lambda_1 + lambda_2", rate}},
      expected,
      [&](const scheme_entry& e, double dt, std::int64_t) { return refine_exponents(s, e, dt, target); }};
  auto tables = answer_all(c, schemes, asymptotic_levels(s, resolution), q);
  for (std::size_t k = 0; k < tables.size(); ++k) {
    for (auto& u : tables[k].uncertainty) u += Eigen::Vector2d(exact.uncertainty, exact.sum_uncertainty);
    report_orders(q, expected(schemes[k]), tables[k], out);
  }
}

}  // namespace polhode
