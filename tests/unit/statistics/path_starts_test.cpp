// SPDX-License-Identifier: Apache-2.0
// Starts of paths and products of lanes given one by one: what makes two alike, and how probable that is.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "statistics/noise/path_audit.hpp"

namespace polhode {
namespace {

/// Probability of what two paths, alike in but one number, are found to be.
template <class Change>
double of_two(int steps, int rows, int drawn, Change change) {
  std::vector<double> z(static_cast<std::size_t>(steps * rows));
  for (std::size_t i = 0; i < z.size(); ++i) z[i] = std::sin(1.0 + static_cast<double>(i));
  path_audit audit;
  audit.add_start(z.data(), steps, rows, drawn);
  change(z);
  audit.add_start(z.data(), steps, rows, drawn);
  return audit.probability_of_repeats();
}

// The first four steps of what is drawn, and nothing else.
TEST(PathStarts, APathIsAnotherByAnyNumberOfItsStart) {
  constexpr int rows = 3, drawn = 2;
  for (const int steps : {2, 6})
    for (int i = 0; i < steps; ++i)
      for (int k = 0; k < rows; ++k) {
        const double found =
            of_two(steps, rows, drawn, [&](auto& z) { z[static_cast<std::size_t>(i * rows + k)] += 1; });
        if (i < 4 && k < drawn)
          EXPECT_EQ(found, 1) << i << ", " << k;
        else
          EXPECT_LT(found, 1e-10) << i << ", " << k;
      }
}

template <class Real>
void expect_lanes_to_be_told_apart(int steps) {
  constexpr int rows = 3, drawn = 2;
  const auto size = static_cast<std::size_t>(steps * rows * path_audit::lanes);
  std::vector<Real> z(size);
  for (std::size_t i = 0; i < size; ++i) z[i] = std::sin(Real(1) + static_cast<Real>(i));
  const auto at = [&](int i, int k, int lane) -> Real& {
    return z[static_cast<std::size_t>((i * rows + k) * path_audit::lanes + lane)];
  };
  for (int i = 0; i < steps; ++i)
    for (int k = 0; k < rows; ++k) at(i, k, 60) = at(i, k, 3);
  for (int i = 0; i < steps; ++i)
    for (int k = 0; k < rows; ++k) {
      at(i, k, 60) += 1;
      path_audit audit;
      audit.add_starts(z.data(), steps, rows, drawn);
      if (i < 4 && k < drawn)
        EXPECT_EQ(audit.probability_of_repeats(), 1) << i << ", " << k;
      else
        EXPECT_LT(audit.probability_of_repeats(), 1e-10) << i << ", " << k;
      at(i, k, 60) = at(i, k, 3);
    }
}

TEST(PathStarts, ALaneIsAnotherByAnyNumberOfItsStart) {
  for (const int steps : {2, 6}) {
    expect_lanes_to_be_told_apart<double>(steps);
    expect_lanes_to_be_told_apart<float>(steps);
  }
}

// n (n - 1) / 2 pairs of k numbers each or of one hash of 64 bits, but a probability at most.
TEST(PathStarts, PathsAreAlikeAsRarelyAsTheirNumbersAndTheirHashes) {
  const double q = std::exp2(-23) / std::acos(-1) + std::exp2(-32), hash = std::exp2(-64);
  for (const int steps : {1, 2, 3, 4}) {
    const double expected = std::pow(q, steps) + hash;
    EXPECT_NEAR(of_two(steps, 1, 1, [](auto&) {}) / expected, 1, 1e-12) << steps;
  }
  path_audit many;
  const double same = 0.3;
  for (int path = 0; path < 7400; ++path) many.add_start(&same, 1, 1, 1);
  EXPECT_EQ(many.probability_of_repeats(), 1);
}

double share_of(double largest) {
  constexpr int pairs = path_audit::lanes * (path_audit::lanes - 1) / 2;
  return pairs * std::erfc(largest / std::sqrt(2.0));
}

// Two lanes follow each other and all others are nothing: the first, the last, neighbours, and far apart.
TEST(PathStarts, TheLargestProductIsSeenOfAnyTwoLanes) {
  for (const auto& [b, a] : {std::pair{0, 1}, {0, 63}, {62, 63}, {7, 40}, {40, 41}}) {
    path_audit audit;
    double product = 0, square = 0;
    for (int i = 0; i < 30; ++i) {
      path_audit::row z = path_audit::row::Zero();
      z[b] = std::sin(1.0 + i), z[a] = 1.5 * z[b] + 0.1 * std::cos(2.0 * i);
      audit.add_products(z);
      product += z[a] * z[b];
      square += z[b] * z[b];
    }
    const double expected = share_of(product / std::sqrt(square));
    ASSERT_LT(expected, 0.1);
    EXPECT_NEAR(audit.probability_of_products() / expected, 1, 1e-11) << b << ", " << a;
  }
}

// z_a z_b / |z_b| is z_a, however small z_b.
TEST(PathStarts, ALaneOfSmallNumbersIsComparedAsWell) {
  path_audit audit;
  path_audit::row z = path_audit::row::Constant(0.3);
  z[20] = 4.5;
  audit.add_products(z);
  EXPECT_NEAR(audit.probability_of_products() / share_of(4.5), 1, 1e-12);
}

TEST(PathStarts, OfSmallProductsTheProbabilityIsOne) {
  path_audit audit;
  audit.add_products(path_audit::row::Constant(0.3));
  EXPECT_EQ(audit.probability_of_products(), 1);
}

TEST(PathStarts, WhatHasHeardNothingChangesNothing) {
  path_audit audit;
  path_audit::row z = path_audit::row::Constant(0.3);
  z[20] = 4.5;
  audit.add_products(z);
  audit.merge(path_audit{});
  EXPECT_NEAR(audit.probability_of_products() / share_of(4.5), 1, 1e-12);
  path_audit other;
  other.merge(audit);
  EXPECT_EQ(other.probability_of_products(), audit.probability_of_products());
}

}  // namespace
}  // namespace polhode
