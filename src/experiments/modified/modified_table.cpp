// SPDX-License-Identifier: Apache-2.0
#include "experiments/modified/modified_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/progress_counter.hpp"

namespace polhode {
namespace {

constexpr double longest = 0.3;          // dt times the fastest rate
constexpr int levels = 7;                // all three polynomials of a series hold the dt^4 of a squared residual
constexpr int most_without = 3;          // coarse levels that may have no logarithm
constexpr double least_share = 1e-2;     // of all rates, that a group of parameters is compared with
constexpr double tolerance = 1e-3;       // of a difference, where the operator is refined
constexpr double step_rounding = 1e-14;  // of an operator

// Of a difference: what two refinements may agree on by accident. A rule of n nodes leaves a term
// (lambda dt)^n n! / (2n)! of the expectation, lambda the generator on degree 2; the next rule, of two nodes more,
// leaves (lambda dt)^2 (n+2)(n+1) / ((2n+4)(2n+3)(2n+2)(2n+1)) of that, lambda dt <= 1 at the steps of modified_levels.
// A change that would stop the refinement, a `tolerance` of the difference, but vanishes by accident hides that share
// of itself. (Harmonics that a higher degree adds come back to degree 2 after four factors of dt and more; their share
// is smaller yet. Rounding has its own floor, transfer_refine.cpp.)
constexpr double n = 5;  // the coarsest rule
constexpr double unseen = tolerance * (n + 2) * (n + 1) / ((2 * n + 4) * (2 * n + 3) * (2 * n + 2) * (2 * n + 1));
static_assert(unseen <= unseen_share);

Eigen::VectorXd numbers_of(const body_parameters& p, double residual) {
  const auto& q = p.noise;
  Eigen::VectorXd out(modified_columns::count);
  out << p.quadratic, p.dissipation, q(0, 0), q(0, 1), q(0, 2), q(1, 1), q(1, 2), q(2, 2), residual;
  return out;
}

/// Of an operator at some degree; higher ones are not tried.
struct no_logarithm : std::runtime_error {
  no_logarithm() : std::runtime_error("the operator of a step has no logarithm") {}
};

/// Everything that is asked of one operator; behind the answers the size of (1 - T)^-1, by which slow modes are found.
struct operator_questions {
  generator_family family;
  modified_columns columns;
  law_averages averages;
  exact_averages variances, gap;
  Eigen::VectorXcd slowest;
  Eigen::Vector3d start;
  double horizon, rate;  ///< rate: the fastest

  transfer_question at(double dt) const {
    return {[this, dt](const transfer_operator& op) { return answer(op, dt); },
            {joined(joined(columns.exact, averages.value()), with_zero(joined(variances.value, gap.value))),
             joined(joined(columns.unit, averages.size()), with_zero(joined(variances.size, gap.size))), tolerance,
             columns.exact.size() + averages.count() + variances.count()}};
  }

 private:
  Eigen::VectorXd answer(const transfer_operator& op, double dt) const {
    const auto generator = generator_of_step(op.matrix, dt);
    if (!generator) throw no_logarithm();
    const auto body = family.nearest(*generator);
    return joined(
        joined(numbers_of(body.parameters, body.residual), averages.of(op, start, std::llround(horizon / dt))),
        of_forgetting(op, dt));
  }
  Eigen::VectorXd of_forgetting(const transfer_operator& op, double dt) const {
    if (variances.count() + gap.count() == 0) return Eigen::VectorXd::Zero(1);
    const auto forgetting = sum_of_powers(op);
    Eigen::VectorXd own(gap.count());
    if (own.size() > 0) own[0] = discretisation_gap(forgetting, dt, slowest, dt * rate * rate);  // T's error over dt
    return joined(joined(ergodic_variances(variances, op, forgetting, dt), own),
                  Eigen::VectorXd::Constant(1, forgetting.norm()));
  }
  static Eigen::VectorXd joined(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    Eigen::VectorXd out(a.size() + b.size());
    out << a, b;
    return out;
  }
  static Eigen::VectorXd with_zero(const Eigen::VectorXd& a) { return joined(a, Eigen::VectorXd::Zero(1)); }
};

/// Rounding of T changes its slow modes by rounding times the size of (1 - T)^-1, of themselves: more than it changes
/// its logarithm over dt where they are slower than the fastest rate. Takes that size off the answers.
void add_rounding_of_slow_modes(transfer_answer& found, const Eigen::VectorXd& size, Eigen::Index count) {
  const Eigen::Index answers = found.error.size() - 1;
  found.uncertainty.segment(answers - count, count) +=
      step_rounding * found.error[answers] * size.segment(answers - count, count);
  found.error.conservativeResize(answers);
  found.uncertainty.conservativeResize(answers);
}

std::optional<transfer_answer> answer_at(const subject& s, const scheme_entry& scheme, double dt,
                                         const transfer_question& question, Eigen::Index slow) {
  const auto roundings = std::llround(std::ceil(10 / (dt * fastest_rate(s))));  // of a logarithm over dt
  try {
    auto found = refine(s, scheme, dt, roundings, question);
    if (!found.error.allFinite()) return std::nullopt;
    add_rounding_of_slow_modes(found, question.target.scale, slow);
    found.uncertainty = found.uncertainty.cwiseMax(unseen_share * found.error.cwiseAbs());
    return found;
  } catch (const no_logarithm&) {
    return std::nullopt;
  }
}

}  // namespace

const std::array<std::string_view, modified_columns::count>& modified_columns::names() {
  static constexpr std::array<std::string_view, count> all{
      "k1", "k2", "k3", "theta k1", "theta k2", "theta k3", "Q11", "Q12", "Q13", "Q22", "Q23", "Q33", "residual"};
  return all;
}

modified_columns columns_on(const sphere_problem& problem) {
  const auto p = parameters_of(problem);
  const double c = problem.radius, turn = c * p.quadratic.norm(), damping = c * c * p.dissipation.norm(),
               noise = p.noise.norm(), all = turn + damping + noise, least = least_share * all;
  const auto by_group = [&](double k, double damped, double q) {
    Eigen::VectorXd out(modified_columns::count);
    out << Eigen::Vector3d::Constant(k / c), Eigen::Vector3d::Constant(damped / (c * c)),
        Eigen::VectorXd::Constant(6, q), 1;
    return out;
  };
  return {numbers_of(p, 0), by_group(all, all, all),
          by_group(std::max(turn, least), std::max(damping, least), std::max(noise, least))};
}

level_grid modified_levels(const subject& s) {
  const double rate = fastest_rate(s) * s.scene.horizon;
  auto steps = static_cast<int>(s.scene.steps.front());
  while (steps * longest < rate) steps *= 2;
  while (steps % 2 == 0 && steps * longest >= 2 * rate) steps /= 2;
  level_grid grid{s.scene.horizon, {}};
  for (int i = 0; i < levels; ++i) grid.steps.push_back(steps << i);
  return grid;
}

std::vector<error_table> modified_tables(const context& c, const std::vector<scheme_entry>& schemes,
                                         const modified_columns& columns, const law_averages& averages,
                                         const exact_averages& variances, const known_gap& known) {
  const auto& s = c.subject;
  const auto& gap = known.gap;
  const operator_questions questions{
      generator_family(s.sphere()->radius),     columns,         averages,       variances, gap, known.mode,
      Eigen::Vector3d(s.scene.momentum.data()), s.scene.horizon, fastest_rate(s)};
  const auto grid = modified_levels(s);
  std::vector<error_table> out(schemes.size());
  progress_counter done(static_cast<int>(schemes.size()) * levels, c.progress);
  // A scheme's levels are one piece of work: where the coarsest has no logarithm, a finer one takes its place.
  parallel_for(c.threads, static_cast<int>(schemes.size()), [&](int k) {
    const auto& scheme = schemes[static_cast<std::size_t>(k)];
    auto& table = out[static_cast<std::size_t>(k)];
    table.scheme = scheme.info.name;
    int found = 0;
    for (int i = 0; found < levels && i < levels + most_without; ++i) {
      const double dt = grid.horizon / (static_cast<double>(grid.steps.front()) * (1 << i));
      auto answer = answer_at(s, scheme, dt, questions.at(dt), variances.count() + gap.count());
      if (!answer) continue;
      answer->uncertainty.segment(modified_columns::count, averages.count()) += averages.uncertainty();
      table.add(dt, *answer);
      ++found;
      done.add();
    }
  });
  return out;
}

}  // namespace polhode
