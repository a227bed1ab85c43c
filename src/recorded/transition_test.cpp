// SPDX-License-Identifier: Apache-2.0
#include "recorded/transition_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "algebra/decompositions.hpp"
#include "statistics/distributions.hpp"

namespace polhode {
namespace {

constexpr double no_direction = 1e-9;  // of the largest variance: a combination of tests that says nothing

std::string name_of(Eigen::Index test) {
  const auto harmonic = [](Eigen::Index index) {
    const auto l = static_cast<Eigen::Index>(std::sqrt(static_cast<double>(index)));
    return fmt::format("({}, {})", l, index - l * l - l);
  };
  return fmt::format("harmonic {} after against {} before", harmonic(test % functions_after + 1),
                     harmonic(test / functions_after));
}

}  // namespace

test_family family_for(double transitions) {
  for (const test_family family : {test_family{degree_after, degree_before}, test_family{2, 2}, test_family{2, 1},
                                   test_family{1, 1}, test_family{1, 0}})
    if (transitions >= transitions_a_test * family.tests()) return family;
  return {};
}

std::vector<Eigen::Index> rows_of(const test_family& family) {
  std::vector<Eigen::Index> rows;
  for (int g = 0; g < harmonic_count(family.before); ++g)
    for (int f = 0; f + 1 < harmonic_count(family.after); ++f) rows.push_back(g * functions_after + f);
  return rows;
}

transition_finding test_transitions(const Eigen::VectorXd& residual, const Eigen::MatrixXd& variance,
                                    double transitions) {
  transition_finding out{.family = family_for(transitions)};
  const auto rows = rows_of(out.family);
  if (rows.empty()) return out;
  const Eigen::VectorXd y = residual(rows), scale = variance(rows, rows).diagonal().cwiseMax(1e-300).cwiseSqrt();
  out.z = y.cwiseQuotient(scale);
  Eigen::Index worst = 0;
  out.largest = out.z.cwiseAbs().maxCoeff(&worst);
  out.where = name_of(rows[static_cast<std::size_t>(worst)]);
  const double tests = static_cast<double>(rows.size());
  out.critical = normal_deviate(false_alarms / 4 / tests);
  out.p_largest = std::min(1.0, 2 * tests * normal_tail(out.largest));
  const Eigen::MatrixXd correlation =
      scale.cwiseInverse().asDiagonal() * variance(rows, rows) * scale.cwiseInverse().asDiagonal();
  const auto modes = symmetric_eigenpairs_of(correlation);
  const Eigen::VectorXd along = modes.vectors.transpose() * out.z;
  for (Eigen::Index i = 0; i < along.size(); ++i)
    if (modes.values[i] > no_direction * modes.values.maxCoeff()) {
      out.squares += along[i] * along[i] / modes.values[i];
      ++out.rank;
    }
  out.p_squares = chi_squared_tail(out.squares, out.rank);
  return out;
}

}  // namespace polhode
