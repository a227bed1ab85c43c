// SPDX-License-Identifier: Apache-2.0
#include "sphere/galerkin/propagation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "algebra/exponential_action.hpp"
#include "sphere/harmonics/observables.hpp"

namespace polhode {
namespace {

constexpr double affordable = 1e10;  // multiplications
constexpr double in_hope = 0.05;     // of that, where it ends only if the start is forgotten

}  // namespace

std::optional<propagated_value> propagated(const sparse_matrix& tall, const Eigen::VectorXd& f,
                                           const Eigen::VectorXd& y, double time, const suprema_of_basis& suprema) {
  const sparse_matrix whole = tall.topRows(tall.cols());
  const index_set block = blocks_of(whole, f);
  const sparse_matrix part = submatrix(whole, block);
  const double cost = exponential_action_products(part, time) * static_cast<double>(part.nonZeros());
  const double hoped = cost > affordable ? time * in_hope * affordable / cost : time;  // it may relax by then
  const sparse_matrix beyond = columns_of(tall, block).bottomRows(tall.rows() - tall.cols());
  const auto remainder = [&](const Eigen::VectorXd& g) { return suprema.beyond(beyond * g); };
  Eigen::VectorXd varying = Eigen::VectorXd::Zero(f.size());
  const double least = rounding_of_sums * f.norm() / suprema.unit_of_mean;
  const Eigen::VectorXd start = f(block);
  double before = remainder(start), bound = 0, steps = 0, passed = 0, apart = unbounded;
  const auto g = exponential_action(part, time, start, [&](const Eigen::VectorXd& now, double dt) {
    const double after = remainder(now);
    bound += dt * std::max(std::exchange(before, after), after);
    passed += dt;
    ++steps;
    varying(block) = now;
    varying[0] = 0;
    apart = suprema.inside(varying);
    return apart > least && passed <= hoped;
  });
  const bool relaxed = apart <= least && passed < (1 - 1e-9) * time;
  if (!relaxed && cost > affordable) return {};
  const double floor = least * std::max(1.0, std::sqrt(steps) / 10);
  return propagated_value{{y(block).dot(g), floor, bound + 2 * (relaxed ? apart : 0) + floor}, relaxed};
}

}  // namespace polhode
