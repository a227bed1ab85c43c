// SPDX-License-Identifier: Apache-2.0
// Elimination over runs of indices, against a dense solution and a matrix that it cannot take.
#include <gtest/gtest.h>

#include <random>

#include "algebra/banded_solve.hpp"
#include "support/dense.hpp"

namespace polhode::test {
namespace {

/// Entries within `reach` of the diagonal, which is larger than a row's others by `least`.
sparse_matrix banded(int n, int reach, double least, std::uint64_t seed) {
  std::mt19937_64 bits(seed);
  std::normal_distribution<double> normal;
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i)
    for (int j = std::max(0, i - reach); j <= std::min(n - 1, i + reach); ++j)
      entries.emplace_back(i, j, normal(bits) + (i == j ? least : 0));
  sparse_matrix out(n, n);
  out.setFromTriplets(entries.begin(), entries.end());
  return out;
}

TEST(BandedSolve, IsTheDenseSolution) {
  for (const int n : {1, 2, 7, 60})
    for (const int reach : {0, 1, 5, 100}) {
      const auto a = banded(n, reach, 8, static_cast<std::uint64_t>(n + reach));
      const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(n, -1, 2);
      const auto x = banded_solve(a, right);
      ASSERT_TRUE(x) << n << ' ' << reach;
      const Eigen::VectorXd dense = test::solution_of(a, right);
      EXPECT_LE((*x - dense).norm(), 1e-12 * dense.norm()) << n << ' ' << reach;
    }
}

// One-sided couplings belong to a run as much as those both ways.
TEST(BandedSolve, SeesWhatOnlyOneSideCouples) {
  sparse_matrix a(6, 6);
  for (int i = 0; i < 6; ++i) a.insert(i, i) = 2 + i;
  a.insert(5, 0) = 1;
  a.insert(1, 4) = -3;
  const Eigen::VectorXd right = Eigen::VectorXd::Ones(6);
  const auto x = banded_solve(a, right);
  ASSERT_TRUE(x);
  EXPECT_LE((a * *x - right).norm(), 1e-14);
}

TEST(BandedSolve, HasNothingToSayOfASingularMatrix) {
  sparse_matrix a(3, 3);
  a.insert(0, 0) = 1;
  a.insert(1, 1) = 0;
  a.insert(2, 2) = 1;
  EXPECT_FALSE(banded_solve(a, Eigen::Vector3d::Ones()));
}

}  // namespace
}  // namespace polhode::test
