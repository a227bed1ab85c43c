#include "experiments/stationary_bias.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "experiments/transfer_report.hpp"

namespace polhode {
namespace {

constexpr double density_accuracy = 1e-10;  // in L2
constexpr double tolerance = 5e-4;

/// The distance in L2 of two laws in harmonics; beyond its degree a law has none.
double distance(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  const auto both = std::min(a.size(), b.size());
  return std::sqrt((a.head(both) - b.head(both)).squaredNorm() + a.tail(a.size() - both).squaredNorm() +
                   b.tail(b.size() - both).squaredNorm());
}

double mean_of(const Eigen::VectorXd& density, const sphere_function& f, double radius) {
  const int degree = static_cast<int>(std::lround(std::sqrt(static_cast<double>(density.size())))) - 1;
  return density.dot(harmonic_coefficients([&](const Eigen::Vector3d& x) { return f(radius * x); }, degree));
}

transfer_question question_on(const sphere_problem& problem, const Eigen::VectorXd& density) {
  const auto energy = *named_observable("energy", problem.inertia);
  const sphere_function square = [energy](const Eigen::Vector3d& pi) { return energy(pi) * energy(pi); };
  const Eigen::Vector3d exact(mean_of(density, energy, problem.radius), mean_of(density, square, problem.radius), 0);
  return {[density, energy, square](const transfer_operator& op) -> Eigen::VectorXd {
            const Eigen::VectorXd law = op.stationary_law().transpose();
            return Eigen::Vector3d(law.dot(op.basis.coefficients(energy)), law.dot(op.basis.coefficients(square)),
                                   distance(law, density));
          },
          {exact, Eigen::Vector3d(exact[0], exact[1], density.norm()), tolerance}};
}

}  // namespace

stationary_law true_law(const subject& s) {
  const auto problem = *sphere_problem_of(s);
  auto law = stationary(problem, density_accuracy);
  if (s.model->noise() != noise_class::isotropic || !law.density) return law;
  const double beta = 2 * problem.theta / problem.covariance(0, 0);
  const auto energy = *named_observable("energy", problem.inertia);
  law.density = harmonic_coefficients(
      [&](const Eigen::Vector3d& x) { return std::exp(-beta * energy(problem.radius * x)); }, law.degree);
  *law.density /= std::sqrt(4 * std::numbers::pi) * (*law.density)[0];
  return law;
}

void report_stationary_bias(const context& c, report::results& out) {
  const auto& s = c.subject;
  const auto problem = sphere_problem_of(s);
  if (!problem) {
    out.skipped.push_back({"gibbs", "", "bias by transfer operators: for the rigid body alone"});
    return;
  }
  const auto law = true_law(s);
  if (!law.density || !law.reason.empty()) {
    out.skipped.push_back({"gibbs", "", "bias by transfer operators: the true stationary law is " + law.reason});
    return;
  }
  std::vector<scheme_entry> schemes;
  for (const auto& e : s.schemes)
    if (e.info.casimir.exact) schemes.push_back(e);
  const auto question = question_on(*problem, *law.density);
  const auto expected = [&](const scheme_entry& e) { return weak_order_on(e.info, s.model->noise()); };
  const order_question q{
      "gibbs",
      "order of the stationary bias",
      {{"bias", "energy", question.target.scale[0]},
       {"bias", "energy^2", question.target.scale[1]},
       {"distance", "density", question.target.scale[2]}},
      expected,
      [&](const scheme_entry& e, double dt, std::int64_t steps) { return refine(s, e, dt, steps, question); }};
  const auto tables = answer_all(c, schemes, scene_levels(s), q);
  for (std::size_t k = 0; k < tables.size(); ++k) report_orders(q, expected(schemes[k]), tables[k], out);
}

}  // namespace polhode
