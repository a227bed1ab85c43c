// SPDX-License-Identifier: Apache-2.0
#include "sphere/galerkin/poisson.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "algebra/banded_solve.hpp"

namespace polhode {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

}  // namespace

double harmonic_supremum(const Eigen::VectorXd& coefficients, int first_degree) {
  double sum = 0;
  Eigen::Index at = 0;
  for (int l = first_degree; at < coefficients.size(); at += 2 * l + 1, ++l)
    sum += std::sqrt((2 * l + 1) / (4 * std::numbers::pi)) * coefficients.segment(at, 2 * l + 1).norm();
  return sum;
}

std::optional<projected_value> poisson_mean(const sparse_matrix& tall, const Eigen::VectorXd& f, int most,
                                            const supremum_bound& supremum) {
  const sparse_matrix square = tall.topRows(tall.cols());
  index_set block = blocks_of(square, f);
  if (std::ssize(block) > most) return std::nullopt;
  if (!block.empty() && block.front() == 0) block.erase(block.begin());
  Eigen::VectorXd u = Eigen::VectorXd::Zero(tall.cols());
  if (!block.empty()) {
    const auto solved = banded_solve(submatrix(square, block), f(block));
    if (!solved) return std::nullopt;
    u(block) = *solved;
  }
  Eigen::VectorXd remainder = -(tall * u);
  remainder.head(f.size()) += f;
  const double mean = remainder[0];
  remainder[0] = 0;
  const Eigen::VectorXd sizes = tall.cwiseAbs() * u.cwiseAbs();
  const double floor = epsilon * (supremum(sizes) + std::fabs(mean));
  return projected_value{mean, floor, supremum(remainder) + floor};
}

}  // namespace polhode
