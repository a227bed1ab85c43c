// SPDX-License-Identifier: Apache-2.0
// Short vectors of fixed and of open size, and inverses of small matrices, against Eigen.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include <polhode/simd.hpp>
#include <polhode/solve.hpp>
#include <polhode/vec.hpp>

#include "support/dense.hpp"

namespace polhode {
namespace {

using open = vec<double, -8>;

template <class Vector>
Vector filled(std::initializer_list<double> numbers) {
  auto out = zeros<Vector>(static_cast<int>(numbers.size()));
  int i = 0;
  for (const double x : numbers) out[i++] = x;
  return out;
}

template <class Vector>
void expect_numbers(const Vector& found, std::initializer_list<double> numbers) {
  ASSERT_EQ(found.size, static_cast<int>(numbers.size()));
  int i = 0;
  for (const double x : numbers) EXPECT_EQ(found[i++], x);
  EXPECT_EQ(found.end() - found.begin(), found.size);
}

template <class Vector>
void vectors_calculate() {
  const auto a = filled<Vector>({1, -2, 3, 0.5}), b = filled<Vector>({4, 8, -0.5, 2});
  expect_numbers(a + b, {5, 6, 2.5, 2.5});
  expect_numbers(a - b, {-3, -10, 3.5, -1.5});
  expect_numbers(-a, {-1, 2, -3, -0.5});
  expect_numbers(3.0 * a, {3, -6, 9, 1.5});
  EXPECT_EQ(dot(a, b), 4 - 16 - 1.5 + 1);
  expect_numbers(a + zero_vector{}, {1, -2, 3, 0.5});
  expect_numbers(zero_vector{} + a, {1, -2, 3, 0.5});
  expect_numbers(zeros<Vector>(4), {0, 0, 0, 0});
}

TEST(Vec, OfFixedSizeCalculates) { vectors_calculate<vec<double, 4>>(); }
TEST(Vec, OfOpenSizeCalculates) {
  vectors_calculate<open>();
  const auto a = filled<open>({1, 2});
  expect_numbers(a + open(), {1, 2});
  expect_numbers(open() + a, {1, 2});
  expect_numbers(a - open(), {1, 2});
  expect_numbers(open() - a, {-1, -2});
  auto assigned = filled<open>({7, 8, 9});
  assigned = a;
  expect_numbers(assigned, {1, 2});
}

TEST(Vec, CrossAndScaled) {
  const auto a = filled<vec<double, 3>>({1, 2, 3}), b = filled<vec<double, 3>>({4, 5, 7});
  expect_numbers(cross(a, b), {-1, 5, -3});
  expect_numbers(scaled(a, b), {4, 10, 21});
  expect_numbers(scaled(filled<open>({1, 2, 3}), filled<open>({4, 5, 7})), {4, 10, 21});
}

/// Rows of random numbers, of which the first of the first column is small: it asks for a pivot.
Eigen::MatrixXd random_rows(int n, unsigned seed) {
  std::mt19937 bits(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Eigen::MatrixXd out(n, n);
  for (auto& x : out.reshaped()) x = uniform(bits);
  out(0, 0) = 1e-14;
  return out;
}

template <class S, int N>
matrix<S, N> rows_of(const Eigen::MatrixXd& a) {
  auto out = zeros<matrix<S, N>>(static_cast<int>(a.rows()));
  for (int i = 0; i < a.rows(); ++i) {
    out[i] = zeros<vec<S, N>>(static_cast<int>(a.cols()));
    for (int j = 0; j < a.cols(); ++j) out[i][j] = S(a(i, j));
  }
  return out;
}

template <int N>
void expect_inverse(int n) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Eigen::MatrixXd a = random_rows(n, seed), expected = test::solution_of(a, Eigen::MatrixXd::Identity(n, n));
    const auto found = inverse(rows_of<double, N>(a));
    const auto packed = inverse(rows_of<pack, N>(a));
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        EXPECT_NEAR(found[i][j], expected(i, j), 1e-11 * expected.norm()) << n << ' ' << seed;
        EXPECT_EQ(packed[i][j][0], found[i][j]);
      }
    const auto x = rows_of<double, N>(a);
    const auto product = times(x, found[0]);
    for (int i = 0; i < n; ++i) EXPECT_NEAR(product[i], a.row(i).dot(expected.row(0)), 1e-11 * expected.norm());
  }
}

TEST(Solve, InversesByCofactorsAndByElimination) {
  expect_inverse<3>(3);
  expect_inverse<5>(5);
  expect_inverse<-6>(6);
  expect_inverse<-6>(2);
}

// 2 - d in place of 1 / d: all but a factor d (2 - d).
TEST(Solve, ATruncatedQuotientLeavesASquare) {
  const Eigen::Matrix3d a = Eigen::Matrix3d::Identity() + 0.01 * Eigen::Matrix3d(random_rows(3, 1));
  const double d = a.determinant();
  const auto found = inverse<quotient::truncated>(rows_of<double, 3>(a));
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(found[i][j], a.inverse()(i, j) * d * (2 - d), 1e-15);
}

TEST(Solve, ASingularMatrixHasNoFiniteInverse) {
  for (const int n : {3, 4}) {
    const auto found = inverse(rows_of<double, -6>(Eigen::MatrixXd::Ones(n, n)));
    bool finite = true;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) finite = finite && std::isfinite(found[i][j]);
    EXPECT_FALSE(finite) << n;
  }
}

}  // namespace
}  // namespace polhode
