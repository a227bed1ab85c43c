// SPDX-License-Identifier: Apache-2.0
#include "recorded/transition_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/common/experiment.hpp"
#include "problem/vectors.hpp"
#include "recorded/claims.hpp"
#include "sphere/harmonics/observables.hpp"
#include "statistics/distributions.hpp"

namespace polhode {
namespace {

constexpr std::size_t most_classes = 64;
constexpr double same = 1e-6;               // radius and interval, relative
constexpr double operator_accuracy = 1e-8;  // of a harmonic's mean: far below what can be sampled
constexpr double noise_margin = 0.1;        // a pass would have seen a noise so far off
constexpr double energy_margin = 0.25;      // of what dissipation takes: the widest half interval of a pass

bool near(double a, double b) { return std::fabs(a - b) <= same * std::fabs(b); }

std::string told(const followed_equation& e) {
  if (!e.reason.empty()) return e.reason;
  std::string out = "the data follow";
  for (const auto& p : e.parameters)
    if (!p.held)
      out += fmt::format("{} {} = {:.4g} [{:.4g}, {:.4g}] (scene: {:.4g})", out.ends_with("follow") ? "" : ",", p.name,
                         p.value.value, p.value.low, p.value.high, p.in_scene);
  return out;
}

}  // namespace

transition_report::transition_report(const subject& s) : subject_(s) {
  if (!s.sphere()->has_noise()) reason_ = "no noise: a state has one successor, and no law";
}

transition_class* transition_report::class_of(double radius, double dt) {
  const auto found = std::ranges::find_if(
      classes_, [&](const transition_class& c) { return near(radius, c.radius) && near(dt, c.dt); });
  if (found != classes_.end()) return &*found;
  if (classes_.size() == most_classes) {
    reason_ = fmt::format("paths on more than {} spheres and intervals: each has a law of its own", most_classes);
    return nullptr;
  }
  auto law = transition(on_radius(subject_.scene, radius), dt, 2 * degree_after, operator_accuracy);
  if (!law.reason.empty()) {
    reason_ = fmt::format("the law after an interval of {:g} is {}", dt, law.reason);
    return nullptr;
  }
  classes_.push_back({radius, dt, transition_moments(std::move(law))});
  return &classes_.back();
}

void transition_report::add(const recorded_transition& t) {
  if (!reason_.empty()) return;
  auto* c = class_of(length(t.start), t.dt);
  if (c == nullptr) return;
  const Eigen::Vector3d before(t.before.data()), after(t.after.data());
  c->moments.add(before.normalized(), after.normalized());
  ++count_;
  dissipated_ += t.dt * subject_.model->dissipation_rate(t.before);
}

followed_equation transition_report::report(recorder& record) {
  if (reason_.empty() && family_for(count_).tests() == 0)
    reason_ = fmt::format("{:g} transitions; at least {:g} would do", count_, fewest_transitions);
  if (!reason_.empty()) {
    const auto kind =
        subject_.sphere()->has_noise() ? report::verdict_kind::inconclusive : report::verdict_kind::skipped;
    for (const char* claim : {recorded_claim::transition_law, recorded_claim::energy_law})
      record.verdict(claim, {.kind = kind, .reason = reason_});
    return {{}, reason_};
  }
  Eigen::VectorXd residual = Eigen::VectorXd::Zero(all_tests);
  Eigen::MatrixXd variance = Eigen::MatrixXd::Zero(all_tests, all_tests);
  for (auto& c : classes_) {
    residual += c.moments.sums().residual(c.moments.law().columns);
    variance += c.moments.sums().variance;
  }
  auto equation = equation_followed(subject_, classes_, variance, family_for(count_));
  for (const auto& p : equation.parameters)
    if (!p.held) record.value({"parameter that the data follow", p.name, "", "recorded"}, p.value);
  report_transitions(residual, variance, equation, record);
  report_energy(record);
  return equation;
}

void transition_report::report_transitions(const Eigen::VectorXd& residual, const Eigen::MatrixXd& variance,
                                           const followed_equation& equation, recorder& record) const {
  const auto found = test_transitions(residual, variance, count_);
  curve z{{"z of each test", "", "", "exact law"}, "test", ""};
  for (Eigen::Index i = 0; i < found.z.size(); ++i) z.add(static_cast<double>(i + 1), found.z[i]);
  const auto written = record.series(z);
  double off = 1;  // half interval of the noise, relative
  if (equation.reason.empty()) {
    const auto& sigma = equation.parameters.front();
    off = (sigma.value.high - sigma.value.low) / 2 / sigma.in_scene;
  }
  report::verdict v{.expected = 0, .estimate = found.largest, .low = 0, .high = found.critical};
  v.kind = found.refuted()       ? report::verdict_kind::refuted
           : off <= noise_margin ? report::verdict_kind::holds
                                 : report::verdict_kind::inconclusive;
  v.reason = fmt::format(
      "{:g} transitions, {} tests: largest |z| {:.2f} of {:.2f} ({}), p = {:.2g}; sum of squares {:.1f} for {}, p = "
      "{:.2g}; "
      "budget of false alarms {:g}; {}",
      count_, found.family.tests(), found.largest, found.critical, found.where, found.p_largest, found.squares,
      found.rank, found.p_squares, false_alarms, told(equation));
  if (v.kind == report::verdict_kind::inconclusive)
    v.reason += fmt::format("; too few to see a noise {:g} % off", 100 * noise_margin);
  record.verdict(recorded_claim::transition_law, std::move(v), {written});
}

void transition_report::report_energy(recorder& record) {
  double excess = 0, variance = 0, time = 0;
  for (auto& c : classes_) {
    const auto problem = on_radius(subject_.scene, c.radius);
    const Eigen::VectorXd h = observable_coefficients(
                                  problem, [&](const Eigen::Vector3d& x) { return problem.energy(x); }, degree_after)
                                  .tail(functions_after) *
                              unit_of_mean;  // of tests with the constant harmonic before
    const auto& sums = c.moments.sums();
    excess += h.dot(sums.residual(c.moments.law().columns).head(functions_after));
    variance += h.dot(sums.variance.topLeftCorner(functions_after, functions_after) * h);
    time += sums.count * c.dt;
  }
  const double rate = excess / time, half = 1.96 * std::sqrt(variance) / time, power = dissipated_ / time;
  const double z = excess / std::sqrt(variance), p = 2 * normal_tail(std::fabs(z));
  report::verdict v{.expected = 0, .estimate = rate, .low = rate - half, .high = rate + half};
  v.kind = p < false_alarms                             ? report::verdict_kind::refuted
           : power > 0 && half <= energy_margin * power ? report::verdict_kind::holds
                                                        : report::verdict_kind::inconclusive;
  v.reason = fmt::format(
      "the energy changes by {:.3g} [{:.3g}, {:.3g}] a time more than the equation says, which dissipates "
      "{:.3g}; z = {:.2f}, p = {:.2g}",
      rate, rate - half, rate + half, power, z, p);
  record.value({"energy gained beyond the law", "energy", "", "recorded"}, rate, rate - half, rate + half);
  record.verdict(recorded_claim::energy_law, std::move(v));
}

}  // namespace polhode
