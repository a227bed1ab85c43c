#include "experiments/stationary_bias.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "experiments/transfer_report.hpp"
#include "experiments/undecided.hpp"

namespace polhode {
namespace {

constexpr double density_accuracy = 1e-10;  // in L2
constexpr double usable = 1e-4;             // of the density's norm: where that accuracy is out of reach
constexpr const char* bias_claim = "order of the stationary bias";
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

stationary_law law_of(const sphere_problem& problem, bool isotropic, double accuracy) {
  auto law = stationary(problem, accuracy);
  if (!isotropic || !law.density) return law;
  const double beta = 2 * problem.theta / problem.covariance(0, 0);
  const auto energy = *named_observable("energy", problem.inertia);
  law.density = harmonic_coefficients(
      [&](const Eigen::Vector3d& x) { return std::exp(-beta * energy(problem.radius * x)); }, law.degree);
  *law.density /= std::sqrt(4 * std::numbers::pi) * (*law.density)[0];
  return law;
}

bool is_usable(const stationary_law& law) {
  return law.density && (law.reason.empty() || law.uncertainty <= usable * law.density->norm());
}

/// What is asked of a law on the sphere: the means of h and h^2, and how far its density is from another.
struct asked_of_law {
  sphere_function energy, square;
  double radius;

  explicit asked_of_law(const sphere_problem& p)
      : energy(*named_observable("energy", p.inertia)),
        square([h = energy](const Eigen::Vector3d& pi) { return h(pi) * h(pi); }),
        radius(p.radius) {}
  Eigen::Vector3d of(const Eigen::VectorXd& density, const Eigen::VectorXd& from) const {
    return {mean_of(density, energy, radius), mean_of(density, square, radius), distance(density, from)};
  }
};

transfer_question question_on(const asked_of_law& asked, const Eigen::VectorXd& density) {
  const Eigen::Vector3d exact = asked.of(density, density);
  return {[density, asked](const transfer_operator& op) -> Eigen::VectorXd {
            const Eigen::VectorXd law = op.stationary_law().transpose();
            return Eigen::Vector3d(law.dot(op.basis.coefficients(asked.energy)),
                                   law.dot(op.basis.coefficients(asked.square)), distance(law, density));
          },
          {exact, Eigen::Vector3d(exact[0], exact[1], density.norm()), tolerance}};
}

/// With what moves them: difference quotients, no better than their share need be.
std::vector<error_column> columns_of(const asked_of_law& asked, const sphere_problem& p, bool isotropic,
                                     const Eigen::VectorXd& density, const Eigen::Vector3d& scale) {
  constexpr double accuracy = 1e-8;
  const Eigen::Vector3d now = asked.of(density, density);
  const auto moved = [&](const sphere_problem& other) -> Eigen::Vector3d {
    const auto law = law_of(other, isotropic, accuracy);
    if (!is_usable(law)) return Eigen::Vector3d::Zero();
    return (asked.of(*law.density, density) - now) / sensitivity_share;
  };
  const Eigen::Vector3d noise = moved(with_more_noise(p, sensitivity_share)),
                        dissipation = moved(with_more_dissipation(p, sensitivity_share));
  return {{"bias", "energy", scale[0], noise[0], dissipation[0]},
          {"bias", "energy^2", scale[1], noise[1], dissipation[1]},
          {.quantity = "distance", .observable = "density", .scale = scale[2], .distance = true}};
}

}  // namespace

stationary_law true_law(const subject& s) {
  return law_of(*sphere_problem_of(s), s.model->noise() == noise_class::isotropic, density_accuracy);
}

void report_stationary_bias(const context& c, report::results& out) {
  const auto& s = c.subject;
  const auto problem = sphere_problem_of(s);
  if (!problem) {
    out.skipped.push_back({"gibbs", "", "bias by transfer operators: for the rigid body alone"});
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
  if (!is_usable(law)) {
    const auto known =
        law.density ? fmt::format("known to {:.1g} of its norm, ", law.uncertainty / law.density->norm()) : "";
    leave_open(schemes, "gibbs", bias_claim, "the true stationary law is " + known + law.reason, out);
    return;
  }
  const asked_of_law asked(*problem);
  const auto question = question_on(asked, *law.density);
  const auto columns =
      columns_of(asked, *problem, s.model->noise() == noise_class::isotropic, *law.density, question.target.scale);
  const auto expected = [&](const scheme_entry& e) { return weak_order_on(e.info, s.model->noise()); };
  const order_question q{
      "gibbs",
      bias_claim,
      columns,
      expected,
      [&](const scheme_entry& e, double dt, std::int64_t steps) { return refine(s, e, dt, steps, question); },
      [&](const scheme_entry& e, double dt, std::int64_t steps) {
        return change_by_far_noise(s, e, dt, steps, question.ask);
      }};
  auto tables = answer_all(c, schemes, scene_levels(s), q);
  for (auto& table : tables)
    for (auto& u : table.uncertainty) u += law.uncertainty * question.target.scale / law.density->norm();
  for (std::size_t k = 0; k < tables.size(); ++k) report_orders(q, expected(schemes[k]), tables[k], out);
}

}  // namespace polhode
