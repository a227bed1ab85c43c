#include "experiments/stationary_bias.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>

#include "experiments/transfer_report.hpp"
#include "experiments/undecided.hpp"
#include "references/sparse_blocks.hpp"

namespace polhode {
namespace {

constexpr double density_accuracy = 1e-10;  // in L2
constexpr double usable = 1e-4;             // of the density's norm: where that accuracy is out of reach
constexpr const char* bias_claim = "order of the stationary bias";
constexpr double tolerance = 5e-4;
constexpr double more_degrees = 3;  // times the last change with the degree: what all higher ones may change yet
constexpr double mean_accuracy = 1e-10, usable_mean = 1e-5,
                 sensitivity_accuracy = 1e-6;  // of an observable's size

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

/// What the schemes' laws are compared with.
struct bias_reference {
  std::vector<error_column> columns;
  transfer_question question;
  Eigen::VectorXd uncertainty;  ///< that is not in the question's answers
  double widened = 1;           ///< times which their own uncertainty is taken
};

/// By the density itself.
bias_reference by_density(const sphere_problem& p, bool isotropic, const stationary_law& law) {
  const asked_of_law asked(p);
  const auto question = question_on(asked, *law.density);
  const auto& scale = question.target.scale;
  return {columns_of(asked, p, isotropic, *law.density, scale), question,
          law.uncertainty / law.density->norm() * scale};
}

/// The coefficients of the equation's own stationary law, projected on harmonics up to each degree that is asked for.
class projected_laws {
 public:
  explicit projected_laws(const sphere_problem& p) : problem_(p) {}
  Eigen::VectorXd of(int degree) {
    const std::lock_guard lock(one_);
    auto& law = laws_[degree];
    if (law.size() == 0) {
      const int count = harmonic_count(degree);
      law = left_null_vector(backward_operator(problem_, degree), count)
                .value_or(Eigen::VectorXd::Constant(count, std::numeric_limits<double>::quiet_NaN()));
    }
    return law / std::sqrt(4 * std::numbers::pi);
  }

 private:
  sphere_problem problem_;
  std::mutex one_;
  std::map<int, Eigen::VectorXd> laws_;
};

/// By means that are known where the density is not: of h and h^2, with a bar that a Poisson equation proves
/// (references/poisson.hpp). Empty, with the reason, where it is too wide.
///
/// That bar is wider than the bias at fine steps, and so is what the scheme's own mean still changes with the degree.
/// But the operator of a short step and the generator lack the same harmonics: P exp(dt L) P = 1 + dt P L P + …, so
/// what the degree does to both means is the same but for O(dt), and their difference at one degree settles earlier
/// than either. It is the bias that is found here. Nothing is smooth under one noise vector, and it settles slowly: its
/// uncertainty is three times the last change with the degree.
std::optional<bias_reference> by_means(const sphere_problem& p, std::string& reason) {
  const asked_of_law asked(p);
  const std::array functions{asked.energy, asked.square};
  const std::array names{"energy", "energy^2"};
  bias_reference out{
      {}, {{}, {Eigen::VectorXd(2), Eigen::VectorXd(2), tolerance}}, Eigen::VectorXd::Zero(2), more_degrees};
  for (std::size_t k = 0; k < functions.size(); ++k) {
    const auto& f = functions[k];
    const double size = size_on_sphere(f, p.radius);
    const auto now = stationary_mean(p, f, mean_accuracy * size);
    if (!now.value || now.uncertainty > usable_mean * size) {
      reason = now.reason;
      return std::nullopt;
    }
    const auto moved = [&](const sphere_problem& other) {
      const auto value = stationary_mean(other, f, sensitivity_accuracy * size);
      const bool known = value.value && value.uncertainty <= usable_mean * size;
      return known ? (*value.value - *now.value) / sensitivity_share : 0;
    };
    const auto at = static_cast<Eigen::Index>(k);
    out.question.target.exact[at] = out.question.target.scale[at] = *now.value;
    out.columns.push_back({"bias", names[k], *now.value, moved(with_more_noise(p, sensitivity_share)),
                           moved(with_more_dissipation(p, sensitivity_share))});
  }
  out.question.ask = [asked, exact = out.question.target.exact,
                      laws = std::make_shared<projected_laws>(p)](const transfer_operator& op) -> Eigen::VectorXd {
    const Eigen::RowVectorXd off = op.stationary_law() - laws->of(op.basis.degree()).transpose();
    return exact +
           Eigen::Vector2d(off.dot(op.basis.coefficients(asked.energy)), off.dot(op.basis.coefficients(asked.square)));
  };
  return out;
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
  std::string reason = law.reason;
  const auto reference = is_usable(law)
                             ? std::optional(by_density(*problem, s.model->noise() == noise_class::isotropic, law))
                             : by_means(*problem, reason);
  if (!reference) {
    leave_open(schemes, "gibbs", bias_claim, "the true stationary mean of h is " + reason, out);
    return;
  }
  const auto expected = [&](const scheme_entry& e) { return weak_order_on(e.info, s.model->noise()); };
  const order_question q{"gibbs",
                         bias_claim,
                         reference->columns,
                         expected,
                         [&](const scheme_entry& e, double dt, std::int64_t steps) {
                           auto found = refine(s, e, dt, steps, reference->question);
                           found.uncertainty *= reference->widened;
                           return found;
                         },
                         [&](const scheme_entry& e, double dt, std::int64_t steps) {
                           return change_by_far_noise(s, e, dt, steps, reference->question.ask);
                         }};
  auto tables = answer_all(c, schemes, scene_levels(s), q);
  for (auto& table : tables)
    for (auto& u : table.uncertainty) u += reference->uncertainty;
  for (std::size_t k = 0; k < tables.size(); ++k) report_orders(q, expected(schemes[k]), tables[k], out);
}

}  // namespace polhode
