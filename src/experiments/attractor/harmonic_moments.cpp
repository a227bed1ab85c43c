// SPDX-License-Identifier: Apache-2.0
#include "experiments/attractor/harmonic_moments.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sphere/harmonics/harmonics.hpp"
#include "transfer/basis_sums.hpp"

namespace polhode {

harmonic_moments::harmonic_moments(int degree)
    : basis_(degree, 1, {1, 1}), sums_(static_cast<std::size_t>(basis_.size() * block_lanes)) {}

void harmonic_moments::add(std::span<const double> states) {
  const double one = 1;
  add_basis({basis_.degree(), 1, 1, 0, basis_.recurrence().data(), block_lanes, 1, &one, states.data(), sums_.data()});
  bodies_ += block_lanes;
}

Eigen::VectorXd harmonic_moments::take() { return take_by_neighbours().rowwise().mean(); }

Eigen::MatrixXd harmonic_moments::take_by_neighbours() {
  const int size = basis_.size(), groups = block_lanes / sum_lanes;
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(size - 1, groups);
  for (int group = 0; group < groups; ++group)
    for (int i = 1; i < size; ++i)
      for (int lane = 0; lane < sum_lanes; ++lane)
        out(i - 1, group) += sums_[static_cast<std::size_t>((group * size + i) * sum_lanes + lane)];
  std::ranges::fill(sums_, 0.0);
  return unit_of_mean * groups / std::exchange(bodies_, 0) * out;
}

Eigen::VectorXd harmonic_moments::of_density(const Eigen::VectorXd& density, int degree) {
  Eigen::VectorXd out = Eigen::VectorXd::Zero(harmonic_count(degree) - 1);
  const auto known = std::min(out.size(), density.size() - 1);
  out.head(known) = unit_of_mean * density.segment(1, known);
  return out;
}

}  // namespace polhode
