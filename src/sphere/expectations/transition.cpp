// SPDX-License-Identifier: Apache-2.0
#include "sphere/expectations/transition.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "algebra/exponential_action.hpp"
#include "algebra/sparse_blocks.hpp"
#include "sphere/galerkin/poisson.hpp"
#include "sphere/galerkin/raise_degree.hpp"
#include "sphere/harmonics/backward_operator.hpp"

namespace polhode {
namespace {

constexpr std::array transition_degrees{8, 12, 16, 24, 32, 48};

transition_law at_degree(const sphere_problem& problem, double time, int reach, int degree) {
  const auto tall = tall_backward_operator(problem, degree);
  const sparse_matrix inside = tall.topRows(tall.cols()), beyond = tall.bottomRows(tall.rows() - tall.cols());
  transition_law out{.degree = degree, .columns = Eigen::MatrixXd::Identity(tall.cols(), harmonic_count(reach))};
  const auto remainder = [&](const Eigen::VectorXd& g) { return harmonic_supremum(beyond * g, degree + 1); };
  for (Eigen::Index j = 1; j < out.columns.cols(); ++j) {  // the constant stays
    double before = remainder(out.columns.col(j)), bound = 0;
    out.columns.col(j) =
        exponential_action(inside, time, out.columns.col(j), [&](const Eigen::VectorXd& now, double dt) {
          const double after = remainder(now);
          bound += dt * std::max(std::exchange(before, after), after);
          return true;
        });
    out.uncertainty = std::max(out.uncertainty, bound);
  }
  return out;
}

}  // namespace

transition_law transition(const sphere_problem& problem, double time, int reach, double tolerance, int wanted) {
  transition_law last;
  for (const int degree :
       wanted > 0 ? std::vector<int>{wanted} : std::vector<int>(transition_degrees.begin(), transition_degrees.end())) {
    if (degree < reach) continue;
    last = at_degree(problem, time, reach, degree);
    if (last.uncertainty <= tolerance) return last;
  }
  last.reason = not_converged(tolerance, last.degree, needed_degree(problem));
  return last;
}

}  // namespace polhode
