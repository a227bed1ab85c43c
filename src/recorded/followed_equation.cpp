// SPDX-License-Identifier: Apache-2.0
#include "recorded/followed_equation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "algebra/decompositions.hpp"
#include "problem/noise_covariance.hpp"
#include "problem/vectors.hpp"
#include "systems/systems.hpp"

namespace polhode {
namespace {

constexpr double difference_share = 1e-4;  // of a parameter's unit
constexpr double nothing_new = 1e-4;       // of what a parameter does, squared: what others do not do
constexpr int most_iterations = 20;
constexpr double settled = 1e-2;                  // standard errors
constexpr double longest_step = 0.5, far = 0.02;  // units of the parameters; beyond `far` slopes are taken anew
constexpr double least_noise = 0.05;              // of the scene's: no noise has no law

/// Of the columns of the operators, all classes at the parameters `p`.
class moment_equations {
 public:
  moment_equations(const subject& s, std::vector<transition_class>& classes, std::vector<fitted_parameter> parameters,
                   const test_family& family)
      : scene_(s.scene), classes_(classes), parameters_(std::move(parameters)), rows_(rows_of(family)) {}

  Eigen::VectorXd residual(const Eigen::VectorXd& p) const {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(all_tests);
    for (auto& c : classes_) {
      const auto law = transition(on_radius(scene_at(p), c.radius), c.dt, degree_after, 0, c.moments.law().degree);
      sum += c.moments.sums().residual(law.columns);
    }
    return sum(rows_);
  }
  /// -d residual / d p, by central differences.
  Eigen::MatrixXd slope(const Eigen::VectorXd& p) const {
    Eigen::MatrixXd out(static_cast<Eigen::Index>(rows_.size()), p.size());
    for (Eigen::Index k = 0; k < p.size(); ++k) {
      Eigen::VectorXd up = p, down = p;
      const double step = difference_share * parameters_[static_cast<std::size_t>(k)].unit;
      up[k] += step;
      down[k] -= step;
      out.col(k) = (residual(down) - residual(up)) / (2 * step);
    }
    return out;
  }

 private:
  report::scene scene_at(const Eigen::VectorXd& p) const {
    report::scene s = scene_;
    for (std::size_t k = 0; k < parameters_.size(); ++k) parameters_[k].set(s, p[static_cast<Eigen::Index>(k)]);
    return s;
  }

  const report::scene& scene_;
  std::vector<transition_class>& classes_;
  std::vector<fitted_parameter> parameters_;
  std::vector<Eigen::Index> rows_;
};

/// Those of which something is left when what those before them do is taken out.
std::vector<Eigen::Index> independent_columns(const Eigen::MatrixXd& information) {
  std::vector<Eigen::Index> kept;
  for (Eigen::Index k = 0; k < information.cols(); ++k) {
    double left = information(k, k);
    if (!kept.empty()) {
      const Eigen::VectorXd with = information(kept, k);
      left -= with.dot(pseudo_inverse(information(kept, kept)) * with);
    }
    if (information(k, k) > 0 && left > nothing_new * information(k, k)) kept.push_back(k);
  }
  return kept;
}

/// Of sum Y about its mean.
Eigen::MatrixXd observed_covariance(std::vector<transition_class>& classes) {
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(all_tests, all_tests);
  for (auto& c : classes) {
    const auto& sums = c.moments.sums();
    const Eigen::VectorXd y = sums.residual(c.moments.law().columns);
    out += sums.observed - y * y.transpose() / sums.count;
  }
  return out;
}

}  // namespace

sphere_problem on_radius(const report::scene& s, double radius) {
  report::scene moved = s;
  const double factor = radius / length(s.momentum);
  for (double& x : moved.momentum) x *= factor;
  return *find_system(s.system)->offers(moved).sphere;
}

std::vector<fitted_parameter> parameters_to_fit(const subject& s) {
  const auto& scene = s.scene;
  const double strength = isotropic_strength(scene), sigma = strength > 0 ? strength : 1;
  std::vector<fitted_parameter> out{
      {"sigma", sigma, sigma, [=](report::scene& to, double x) { to = with_noise_times(std::move(to), x / sigma); }}};
  const double theta = dissipation_of(scene);
  const double rate = std::max(s.offers->rates.motion, s.offers->rates.noise);
  out.push_back({"theta", theta, theta > 0 ? theta : rate / std::max(s.offers->rates.damping, 1e-300),
                 [=](report::scene& to, double x) { to = with_dissipation(std::move(to), x); }});
  for (std::size_t i = 0; i < scene.parameters.size(); ++i) {
    const auto& p = scene.parameters[i];
    if (p.name == noise_key || p.name == dissipation_key || p.rows.empty()) continue;
    const auto columns = p.rows.front().size(), count = p.rows.size() * columns;
    double largest = 0;
    for (const auto& row : p.rows) largest = std::max(largest, length(row));
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t r = k / columns, c = k % columns;
      const bool matrix = p.shape == report::shape::vectors;
      if (matrix && c < r) continue;  // symmetric
      const double now = p.rows[r][c];
      const auto name = p.shape == report::shape::number ? p.name
                        : matrix                         ? fmt::format("{}_{}{}", p.name, r + 1, c + 1)
                                                         : fmt::format("{}_{}", p.name, c + 1);
      out.push_back({name, now,
                     now != 0      ? std::fabs(now)
                     : largest > 0 ? largest
                                   : rate,
                     [=](report::scene& to, double x) {
                       to.parameters[i].rows[r][c] = x;
                       if (matrix) to.parameters[i].rows[c][r] = x;
                     }});
    }
  }
  return out;
}

followed_equation equation_followed(const subject& s, std::vector<transition_class>& classes,
                                    const Eigen::MatrixXd& variance, const test_family& family) {
  followed_equation out;
  const auto parameters = parameters_to_fit(s);
  const auto count = static_cast<Eigen::Index>(parameters.size());
  const auto rows = rows_of(family);
  if (static_cast<Eigen::Index>(rows.size()) <= count) return {{}, "too few transitions to tell parameters"};
  const moment_equations equations(s, classes, parameters, family);
  const Eigen::MatrixXd weight = pseudo_inverse(variance(rows, rows));
  Eigen::VectorXd p(count), unit(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    p[k] = parameters[static_cast<std::size_t>(k)].in_scene;
    unit[k] = parameters[static_cast<std::size_t>(k)].unit;
  }
  const Eigen::MatrixXd observed = observed_covariance(classes)(rows, rows);
  const Eigen::MatrixXd first = equations.slope(p) * unit.asDiagonal();
  const auto free = independent_columns(first.transpose() * weight * first);
  const auto solution_at = [&](const Eigen::MatrixXd& slope) -> Eigen::MatrixXd {
    const Eigen::MatrixXd d = slope(Eigen::all, free);
    return pseudo_inverse(d.transpose() * weight * d) * d.transpose() * weight;
  };
  Eigen::MatrixXd solve = solution_at(first), covariance;
  bool done = false;
  for (int i = 0; i < most_iterations && !done; ++i) {
    const Eigen::VectorXd step = solve * equations.residual(p);
    if (!step.allFinite()) break;
    covariance = solve * observed * solve.transpose();
    const Eigen::VectorXd error = covariance.diagonal().cwiseMax(0).cwiseSqrt();
    const double longest = step.cwiseAbs().maxCoeff(), part = std::min(1.0, longest_step / longest);
    for (std::size_t k = 0; k < free.size(); ++k)
      p[free[k]] += part * step[static_cast<Eigen::Index>(k)] * unit[free[k]];
    p[0] = std::max(p[0], least_noise * unit[0]);
    done = part == 1 && (step.cwiseAbs().array() <= settled * error.array()).all();
    if (!done && longest > far) solve = solution_at(equations.slope(p) * unit.asDiagonal());
  }
  if (!done) return {{}, "no parameters near the scene's make an equation that the data follow"};
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto& q = parameters[static_cast<std::size_t>(k)];
    followed_parameter found{q.name, q.in_scene, {p[k], p[k], p[k]}, true};
    if (const auto at = std::ranges::find(free, k); at != free.end()) {
      const auto j = at - free.begin();
      const double half = 1.96 * std::sqrt(std::max(0.0, covariance(j, j))) * unit[k];
      found.value = {p[k], p[k] - half, p[k] + half};
      found.held = false;
    }
    out.parameters.push_back(found);
  }
  return out;
}

}  // namespace polhode
