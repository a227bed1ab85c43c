// SPDX-License-Identifier: Apache-2.0
// Random scenes in sane ranges, and what the errors at a chosen step and below are when they are measured in another
// way: operators at a fixed fine rule, the truth time by time, other random numbers.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "ensemble/noise/paths.hpp"
#include "references/odeint.hpp"
#include "run/choose.hpp"
#include "run/verify.hpp"
#include "sphere/expectations/expectation.hpp"
#include "sphere/stationary.hpp"

namespace polhode::test {

inline select_options asking(const std::string& goal, double tolerance) {
  select_options o;
  o.goal = goal;
  o.tolerance = tolerance;
  o.threads = 2;
  return o;
}

inline scene random_scene(std::mt19937_64& random, int number) {
  const auto between = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
  auto s = load_scene("paper");
  s.name = "random" + std::to_string(number);
  s.vector("inertia") = {between(0.7, 1.5), between(1.5, 2.5), between(2.5, 4)};
  s.number("theta") = between(0.1, 1);
  const double sigma = between(0.3, 0.8), c = between(0.7, 1.5);
  s.vectors("sigma") = {{sigma, 0, 0}, {0, sigma, 0}, {0, 0, sigma}};
  for (double& p : s.momentum) p *= c;
  s.horizon = between(1, 3);
  return s;
}

/// The means of every observable at six times (at equilibrium: one), [observable + count * time].
inline Eigen::VectorXd means_again(const subject& s, const scheme_entry& scheme, double dt, double horizon,
                                   const law_observables& all, bool at_equilibrium, int finer) {
  const auto steps = static_cast<std::int64_t>(std::lround(horizon / dt)), coarse = steps / finer;
  const bool sphere = scheme.info.casimir.exact;
  // Nine nodes a channel leave 5 % of an error of 1e-4 at steps of 2 open, 17 leave 0.2 %.
  const int nodes = !sphere ? 6 : dt > 1 ? 17 : 9;
  const transfer_rule rule{sphere ? basis_rule{22, 1, 0} : basis_rule{12, 7, 5}, {nodes, 3}};
  const auto op = make_transfer(s, scheme, dt, steps, rule);
  Eigen::MatrixXd f(op.basis.size(), all.count());
  for (Eigen::Index i = 0; i < f.cols(); ++i) f.col(i) = op.basis.coefficients(all.functions[std::size_t(i)]);
  if (at_equilibrium) return (op.stationary_law() * f).transpose();
  Eigen::VectorXd out(6 * f.cols());
  const Eigen::Vector3d start = Eigen::Map<const Eigen::Vector3d>(s.scene.momentum.data());
  for (std::int64_t k = 1; k <= 6; ++k)
    out.segment((k - 1) * f.cols(), f.cols()) =
        (op.law_after(start, std::max<std::int64_t>(1, coarse * k / 6) * finer) * f).transpose();
  return out;
}

/// Of each observable in units of its root mean square over the sphere, the largest at any time.
inline double law_error_again(const subject& s, const candidate& who, double dt, double horizon, bool at_equilibrium,
                              const std::string& observable) {
  const auto all = every_observable(s);
  const auto problem = *s.sphere();
  Eigen::VectorXd means = means_again(s, who.scheme, dt, horizon, all, at_equilibrium, 1);
  if (who.combination) means = (4 * means_again(s, who.scheme, dt / 2, horizon, all, at_equilibrium, 2) - means) / 3;
  const auto law = at_equilibrium ? stationary(problem, 1e-13) : stationary_law{};
  const Eigen::Vector3d start = Eigen::Map<const Eigen::Vector3d>(s.scene.momentum.data());
  const auto steps = std::lround(horizon / dt);
  double worst = 0;
  for (Eigen::Index i = 0; i < means.size(); ++i) {
    const auto which = std::size_t(i % all.count());
    if (observable != all_observables && observable != all.names[which]) continue;
    const auto& f = all.functions[which];
    const double t = dt * double(std::max(1L, steps * (long(i / all.count()) + 1) / 6));
    const auto truth = at_equilibrium ? mean(problem, law, f) : expectation(problem, f, start, t, 1e-11);
    worst = std::max(worst, std::fabs(means[i] - truth.value.value()) / all.size[Eigen::Index(which)]);
  }
  return worst;
}

/// The largest distance of the energy from that of the true path at forty times, in units of h_0.
inline double energy_error_again(const subject& bound, const candidate& who, double dt, double horizon) {
  const auto still = bound.without_noise();
  const auto stepper = who.scheme.make(dt);
  const long steps = std::lround(horizon / dt);
  auto states = replicated(still.scene.momentum);
  const double h0 = still.model->energy(still.scene.momentum);
  double worst = 0;
  for (long i = 1; i <= steps; ++i) {
    stepper->advance(states, silence(1));
    if (i % std::max(1L, steps / 40) != 0 && i != steps) continue;
    const double truth = still.model->energy(
        solve_drift([&](std::span<const double> mu, std::span<double> out) { still.model->drift(mu, out); },
                    still.scene.momentum, double(i) * dt));
    worst = std::max(worst, std::fabs(still.model->energy(lane_of(states, 0, 3)) - truth) / h0);
  }
  return worst;
}

/// The root mean square distance with other random numbers.
inline double path_error_again(const context& c, const candidate& who, const goal_question& q, double dt, int seeds) {
  const auto goal = make_goal(c, q);
  double square = 0;
  for (int i = 0; i < seeds; ++i) square += std::pow(goal->error(who, dt, 1000 + std::uint64_t(i)).value, 2) / seeds;
  return std::sqrt(square);
}

/// The largest error at the chosen step and at steps below it that `select` did not look at.
inline double measured_again(const scene& s, const select_options& o, const choice& chosen) {
  const auto bound = bind_scene(s);
  const context c{bound, effort::standard, 2, 77};
  const goal_question q{o.goal, o.observable, s.horizon, o.tolerance};
  const auto candidates = make_goal(c, q)->candidates(bound);
  const auto who = std::ranges::find(candidates, chosen.scheme, &candidate::name);
  const bool strong = o.goal == "strong", equilibrium = o.goal == "stationary";
  double worst = 0;
  for (const double part : strong ? std::vector{1.0, 1.5} : std::vector{1.0, 1.12, 1.6, 3.1, 7.3}) {
    const double dt =
        equilibrium ? chosen.dt / part : s.horizon / std::ceil(s.horizon / chosen.dt * part * (1 - 1e-12));
    const double error = strong               ? path_error_again(c, *who, q, dt, part == 1 ? 10 : 1)
                         : o.goal == "energy" ? energy_error_again(bound, *who, dt, s.horizon)
                                              : law_error_again(bound, *who, dt, equilibrium ? dt : s.horizon,
                                                                equilibrium, o.observable);
    worst = std::isfinite(error) ? std::max(worst, error) : HUGE_VAL;
  }
  return worst;
}

}  // namespace polhode::test
