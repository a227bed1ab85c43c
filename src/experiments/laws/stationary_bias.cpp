#include "experiments/laws/stationary_bias.hpp"

#include <cmath>
#include <numbers>

#include "experiments/common/undecided.hpp"
#include "experiments/laws/bias_reference.hpp"
#include "experiments/laws/transfer_report.hpp"

namespace polhode {
namespace {

constexpr double density_accuracy = 1e-10;  // in L2
constexpr double usable = 1e-4;             // of the density's norm: where that accuracy is out of reach
constexpr const char* bias_claim = "order of the stationary bias";

}  // namespace

stationary_law law_of(const sphere_problem& problem, bool isotropic, double accuracy) {
  auto law = stationary(problem, accuracy);
  if (!isotropic || !law.density) return law;
  const double beta = 2 * problem.damping / problem.covariance(0, 0);
  const auto energy = *named_observable("energy", problem);
  law.density = harmonic_coefficients(
      [&](const Eigen::Vector3d& x) { return std::exp(-beta * energy(problem.radius * x)); }, law.degree);
  *law.density /= std::sqrt(4 * std::numbers::pi) * (*law.density)[0];
  return law;
}

bool is_usable(const stationary_law& law) {
  return law.density && (law.reason.empty() || law.uncertainty <= usable * law.density->norm());
}

stationary_law true_law(const subject& s) {
  return law_of(*s.sphere(), s.model->noise() == noise_class::isotropic, density_accuracy);
}

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
