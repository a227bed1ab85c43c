// SPDX-License-Identifier: Apache-2.0
#include "experiments/energy/energy_trace.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "sphere/closed_forms/energy_drift.hpp"
#include "transfer/points/point_block.hpp"

namespace polhode {
namespace {

constexpr int directions = 8;  // degree of their quadrature
constexpr std::array channel_nodes{5, 7, 9, 11};
constexpr int area_nodes = 2, more_area_nodes = 3;
constexpr double tolerance = 1e-4;       // of the largest error, where nodes are refined
constexpr double mean_rounding = 1e-15;  // of the greatest energy, of the mean over a step
constexpr double still = 1e-12;          // of noise times energy: a drift that is none

/// What is the same for all schemes: the start in row 0, then directions all over the sphere.
struct trace_frame {
  sphere_problem problem;
  sphere_function energy;
  points_in_space points;
  Eigen::VectorXd weight;  ///< of the points, adding up to one; of the start none
  Eigen::VectorXd drift;   ///< L h
  Eigen::VectorXd along;   ///< h - m, of mean square one

  explicit trace_frame(const subject& s) : problem(*s.sphere()) {
    energy = *named_observable("energy", problem);
    const auto rule = sphere_quadrature(directions);
    points.resize(rule.points.rows() + 1, 3);
    points << Eigen::RowVector3d(s.scene.momentum.data()), problem.radius * rule.points;
    weight = Eigen::VectorXd::Zero(points.rows());
    weight.tail(rule.weights.size()) = rule.weights / rule.weights.sum();
    drift = energy_drift(problem, points);
    along.resize(points.rows());
    for (Eigen::Index i = 0; i < along.size(); ++i)
      along[i] = energy(points.row(i).transpose()) - mean_energy_over_sphere(problem);
    along /= size_of(along);
  }
  double size_of(const Eigen::VectorXd& f) const { return std::sqrt(weight.dot(f.cwiseAbs2())); }
  double greatest_energy() const { return greatest_energy_on(problem); }
  /// At the start, along h - m, and the largest.
  Eigen::Vector3d columns_of(const Eigen::VectorXd& f) const {
    return {f[0], (weight.array() * f.array() * along.array()).sum(), f.cwiseAbs().maxCoeff()};
  }
};

std::vector<error_column> columns_on(const trace_frame& frame) {
  const double scale = frame.size_of(frame.drift);
  const Eigen::Vector3d by_noise = 2 * frame.columns_of(frame.drift);  // it is quadratic in sigma
  return {{.quantity = "drift of E[h]", .observable = "at the start", .scale = scale, .by_noise = by_noise[0]},
          {.quantity = "drift of E[h]", .observable = "along h", .scale = scale, .by_noise = by_noise[1]},
          {.quantity = "drift of E[h]", .observable = "largest on the sphere", .scale = scale, .distance = true}};
}

transfer_answer answer(const trace_frame& frame, const subject& s, const scheme_entry& scheme, double dt) {
  const auto exact = energy_without_dissipation(frame.problem, frame.points, dt);
  const auto drift = [&](const noise_rule& rule) -> Eigen::VectorXd {
    return (mean_after_step(s, scheme, dt, rule, frame.points, frame.energy) - exact.value) / dt;
  };
  const double floor = (exact.uncertainty + mean_rounding * frame.greatest_energy()) / dt;
  noise_rule rule{channel_nodes[0], area_nodes};
  Eigen::VectorXd found = drift(rule);
  double change = HUGE_VAL;
  for (std::size_t i = 1; i < channel_nodes.size() && change > std::max(tolerance * found.cwiseAbs().maxCoeff(), floor);
       ++i) {
    rule.channel = channel_nodes[i];
    Eigen::VectorXd next = drift(rule);
    change = (next - found).cwiseAbs().maxCoeff();
    found.swap(next);
  }
  if (scheme.needs_areas)
    change +=
        (drift({channel_nodes[0], more_area_nodes}) - drift({channel_nodes[0], area_nodes})).cwiseAbs().maxCoeff();
  return {frame.columns_of(found), Eigen::Vector3d::Constant(change + floor), true, {{}, rule}};
}

/// Of schemes that keep the sphere, under isotropic noise without a field: h - m is an eigenfunction of the noise.
void report_bound(const trace_frame& frame, const error_table& t, recorder& record) {
  curve bound{{"error of E[h] at any time, at most", "energy", "energy", "transfer"}};
  const double rate = 3 * frame.problem.covariance(0, 0);
  for (std::size_t i = 0; i < t.dt.size(); ++i)
    bound.add(t.dt[i], (t.error[i][2] + t.uncertainty[i][2]) * t.dt[i] / -std::expm1(-rate * t.dt[i]));
  record.series(bound);
}

}  // namespace

void report_energy_trace(const context& c, report::results& out) {
  if (!c.subject.sphere()) return out.skipped.push_back({"energy", "", std::string("trace formula: ") + no_exact_law});
  if (c.subject.model->noise() == noise_class::none)
    return out.skipped.push_back({"energy", "", "trace formula: no noise, so that nothing moves E[h]"});
  const auto s = c.subject.without_dissipation();
  const trace_frame frame(s);
  if (frame.size_of(frame.drift) <= still * frame.problem.covariance.norm() * frame.greatest_energy())
    return out.skipped.push_back({"energy", "", "trace formula: this noise leaves h as it is"});
  const auto expected = [&](const scheme_entry& e) { return weak_order_on(e.info, s.model->noise()); };
  const order_question q{"energy", energy_trace_claim, columns_on(frame), expected,
                         [&](const scheme_entry& e, double dt, std::int64_t) { return answer(frame, s, e, dt); }};
  const auto tables = answer_all({s, c.effort, c.threads}, s.schemes, scene_levels(s), q);
  for (std::size_t k = 0; k < tables.size(); ++k) {
    recorder record(q.experiment, tables[k].scheme, out);
    report_orders(q, expected(s.schemes[k]), tables[k], record);
    if (s.schemes[k].info.casimir.exact && s.model->noise() == noise_class::isotropic && !frame.problem.has_field())
      report_bound(frame, tables[k], record);
  }
}

}  // namespace polhode
