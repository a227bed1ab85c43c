// SPDX-License-Identifier: Apache-2.0
#include "sphere/harmonics/wigner.hpp"

#include <cmath>
#include <vector>

namespace polhode {
namespace {

/// The sphere's generator on the first index (from the left), or its negative on the second (from the right).
sparse_matrix spread(const sparse_matrix& generator, int degree, bool left) {
  sparse_entries entries;
  for (int l = 0; l <= degree; ++l)
    for (int m = -l; m <= l; ++m)
      for (sparse_matrix::InnerIterator entry(generator, harmonic_index(l, m)); entry; ++entry) {
        const int to = static_cast<int>(entry.row()) - harmonic_index(l, 0);
        for (int other = -l; other <= l; ++other)
          if (left)
            entries.emplace_back(wigner_index(l, to, other), wigner_index(l, m, other), entry.value());
          else
            entries.emplace_back(wigner_index(l, other, to), wigner_index(l, other, m), -entry.value());
      }
  return sparse_from(wigner_count(degree), entries);
}

}  // namespace

group_generators wigner_generators(int degree) {
  const auto sphere = rotation_generators(degree);
  group_generators turn;
  for (std::size_t i = 0; i < 3; ++i) {
    turn.left[i] = spread(sphere[i], degree, true);
    turn.right[i] = spread(sphere[i], degree, false);
  }
  return turn;
}

// Between degrees, <l-1 a b| R_33 |l a b> = sqrt((l^2-a^2)(l^2-b^2)) / (l sqrt(4l^2-1)). Inside a degree the vector x_i
// is proportional to left_i right_3 (Wigner-Eckart), and sum_i x_i left_i = right_3, sum_i left_i^2 = -l(l+1) set the
// factor.
std::array<sparse_matrix, 3> wigner_coordinates(int degree, const group_generators& turn) {
  sparse_entries between, inverse_casimir;
  for (int l = 1; l <= degree; ++l)
    for (int a = -l; a <= l; ++a)
      for (int b = -l; b <= l; ++b) {
        const int high = wigner_index(l, a, b);
        inverse_casimir.emplace_back(high, high, -1.0 / (l * (l + 1)));
        if (std::abs(a) == l || std::abs(b) == l) continue;
        const double up = std::sqrt(1.0 * (l * l - a * a) * (l * l - b * b) / (4 * l * l - 1)) / l;
        between.emplace_back(wigner_index(l - 1, a, b), high, up);
        between.emplace_back(high, wigner_index(l - 1, a, b), up);
      }
  const sparse_matrix& one = turn.left[0];
  const sparse_matrix& two = turn.left[1];
  const sparse_matrix inside = sparse_from(wigner_count(degree), inverse_casimir) * turn.right[2];
  std::array<sparse_matrix, 3> x;
  x[2] = sparse_from(wigner_count(degree), between) + sparse_matrix(inside * turn.left[2]);
  x[0] = sparse_matrix(x[2] * two) - sparse_matrix(two * x[2]);  // [left_i, x_j] = eps_ikj x_k
  x[1] = sparse_matrix(one * x[2]) - sparse_matrix(x[2] * one);
  return x;
}

double frame_supremum(const Eigen::VectorXd& f) {
  double sum = 0;
  for (int l = 0; wigner_count(l) <= f.size(); ++l)
    for (int b = -l; b <= l; ++b) {
      double square = 0;
      for (int a = -l; a <= l; ++a) square += std::pow(f[wigner_index(l, a, b)], 2);
      sum += std::sqrt((2 * l + 1) * square);
    }
  return sum;
}

}  // namespace polhode
