// SPDX-License-Identifier: Apache-2.0
// Small matrices over any scalar, real and complex, their products, exponentials and Cayley transforms, against Eigen.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <random>

#include <polhode/lie/complex_matrix.hpp>
#include <polhode/lie/fixed_matrix.hpp>
#include <polhode/lie/matrix_functions.hpp>
#include <polhode/lie/skew_exponential.hpp>
#include <polhode/lie/skew_projection.hpp>
#include <polhode/lie/small_matrix.hpp>

#include "algebra/decompositions.hpp"
#include "support/dense.hpp"

namespace polhode {
namespace {

constexpr int n = 4;
using complex_dense = Eigen::MatrixXcd;
using test::complex_form, test::real_form, test::solution_of;

complex_dense complex_numbers(unsigned seed) {
  std::mt19937 bits(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  complex_dense out(n, n);
  for (auto& x : out.reshaped()) x = {uniform(bits), uniform(bits)};
  return out;
}
complex_dense hermitian(unsigned seed) { return complex_numbers(seed) + complex_numbers(seed).adjoint(); }
complex_dense skew_hermitian(unsigned seed) { return complex_numbers(seed) - complex_numbers(seed).adjoint(); }
complex_dense real_skew(unsigned seed) {
  return (complex_numbers(seed).real() - complex_numbers(seed).real().transpose()).cast<std::complex<double>>();
}

complex_dense exponential(const complex_dense& a) { return complex_form(test::exponential_of(real_form(a))); }

using real_fixed = fixed_matrix<double, n>;
using complex_fixed = complex_matrix<double, n>;
using sized = small_matrix<double, 6>;

template <class M>
M of(const complex_dense& a) {
  M out = M::identity(n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      if constexpr (std::is_same_v<M, complex_fixed>)
        out(i, j) = {a(i, j).real(), a(i, j).imag()};
      else
        out(i, j) = a(i, j).real();
  return out;
}
template <class M>
complex_dense dense(const M& a) {
  complex_dense out(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      if constexpr (std::is_same_v<M, complex_fixed>)
        out(i, j) = {a(i, j).real, a(i, j).imaginary};
      else
        out(i, j) = a(i, j);
  return out;
}
template <class M>
complex_dense seen_by(const complex_dense& a) {
  return dense(of<M>(a));
}

void expect_matrices_near(const complex_dense& found, const complex_dense& expected, double within) {
  EXPECT_LE((found - expected).norm(), within * std::max(1.0, expected.norm()));
}

template <class M>
void matrices_calculate() {
  const auto a = of<M>(complex_numbers(1)), b = of<M>(complex_numbers(2));
  const complex_dense x = seen_by<M>(complex_numbers(1)), y = seen_by<M>(complex_numbers(2));
  expect_matrices_near(dense(a + b), x + y, 0);
  expect_matrices_near(dense(0.3 * a), 0.3 * x, 1e-16);
  expect_matrices_near(dense(a * b), x * y, 1e-15);
  expect_matrices_near(dense(M::identity(n)), complex_dense::Identity(n, n), 0);
}

TEST(Matrices, OfEveryKindCalculate) {
  matrices_calculate<real_fixed>();
  matrices_calculate<complex_fixed>();
  matrices_calculate<sized>();
}

TEST(Matrices, RealProductsAndTransposes) {
  const auto a = of<real_fixed>(complex_numbers(1)), b = of<real_fixed>(complex_numbers(2));
  const Eigen::MatrixXd x = complex_numbers(1).real(), y = complex_numbers(2).real();
  EXPECT_NEAR(inner_product(a, b), x.cwiseProduct(y).sum(), 1e-15);
  expect_matrices_near(dense(transposed(a)), x.transpose().cast<std::complex<double>>(), 0);
  EXPECT_NEAR(of<sized>(complex_numbers(1)).square(), x.squaredNorm(), 1e-14);
  const auto s = of<real_fixed>(real_skew(3)), t = of<real_fixed>(real_skew(4));
  const complex_dense u = real_skew(3), v = real_skew(4);
  expect_matrices_near(dense(skew_commutator(s, t)), u * v - v * u, 1e-15);
  const auto square = s * s, cube = skew_product(square, s);
  expect_matrices_near(dense(self_adjoint_product(s, s)), u * u, 1e-15);
  expect_matrices_near(dense(cube), u * u * u, 1e-15);
}

TEST(Matrices, AConjugatedSkewMatrixIsWhole) {
  const Eigen::MatrixXd m = real_skew(6).real(),
                        v = exponential(0.3 * real_skew(7)).real() - Eigen::MatrixXd::Identity(n, n);
  const auto found = skew_conjugation(of<real_fixed>(v.cast<std::complex<double>>()), of<real_fixed>(real_skew(6)));
  const Eigen::MatrixXd u = v + Eigen::MatrixXd::Identity(n, n), expected = u.transpose() * m * u - m;
  expect_matrices_near(dense(found), expected.cast<std::complex<double>>(), 3e-15);
}

TEST(Matrices, ComplexProductsAndAdjoints) {
  const auto a = of<complex_fixed>(complex_numbers(1)), b = of<complex_fixed>(complex_numbers(2));
  const complex_dense x = complex_numbers(1), y = complex_numbers(2);
  expect_matrices_near(dense(a - b), x - y, 0);
  expect_matrices_near(dense(adjoint(a)), x.adjoint(), 0);
  EXPECT_NEAR(real_product(a, b), (x.adjoint() * y).trace().real(), 1e-14);
  EXPECT_NEAR(a.square(), x.squaredNorm(), 1e-14);
  const complex_dense u = skew_hermitian(3);
  const auto s = of<complex_fixed>(u);
  expect_matrices_near(dense(self_adjoint_product(s, s)), u * u, 1e-15);
  expect_matrices_near(dense(skew_product(s * s, s)), u * u * u, 1e-15);
}

using c = complex_number<double>;
void expect_equal(const c& found, std::complex<double> expected) {
  EXPECT_NEAR(found.real, expected.real(), 1e-15);
  EXPECT_NEAR(found.imaginary, expected.imag(), 1e-15);
}

TEST(ComplexNumber, CalculatesAsStd) {
  const std::complex<double> x(0.3, -0.7), y(1.1, 0.4), z(-0.2, 0.5);
  const c a{0.3, -0.7}, b{1.1, 0.4}, d{-0.2, 0.5};
  expect_equal(a + b, x + y);
  expect_equal(a - b, x - y);
  expect_equal(-a, -x);
  expect_equal(a * b, x * y);
  expect_equal(2.0 * a, 2.0 * x);
  expect_equal(plus_product(d, a, b), z + x * y);
  expect_equal(conjugate(a), std::conj(x));
  expect_equal(reciprocal(a), 1.0 / x);
  expect_equal(times_constant(3, a), 3.0 * x);
  expect_equal(times_constant(b, a), y * x);
  expect_equal(select(true, a, b), x);
  expect_equal(select(false, a, b), y);
}

constexpr double step_sizes[] = {1e-9, 1e-3, 0.2, 1.0, 30.0};  // of a step

/// exp(x) - 1, by x (1 + x/2 (1 + x/3 (…))) where 1 would take its digits.
complex_dense dense_exponential_less_one(const complex_dense& x) {
  const complex_dense one = complex_dense::Identity(n, n);
  if (x.norm() > 0.1) return exponential(x) - one;
  complex_dense sum = one;
  for (int k = 12; k > 1; --k) sum = one + x * sum / k;
  return x * sum;
}

TEST(MatrixFunctions, Exponentials) {
  for (const double size : step_sizes) {
    const complex_dense x = size / skew_hermitian(5).norm() * skew_hermitian(5);
    const auto found = dense(exponential_less_one(of<complex_fixed>(x)));
    EXPECT_LE((found - dense_exponential_less_one(x)).norm(), 2e-15 * size * (1 + size)) << size;
  }
}

template <class M>
void expect_cayley(const complex_dense& skew) {
  for (const double size : step_sizes) {
    const complex_dense x = size / skew.norm() * skew;
    const complex_dense expected =
        complex_form(solution_of(real_form(complex_dense::Identity(n, n) - x / 2), real_form(x)));
    EXPECT_LE((dense(cayley_less_one(of<M>(x))) - expected).norm(), 2e-15 * size * (1 + size)) << size;
  }
}

TEST(MatrixFunctions, CayleyTransforms) {
  expect_cayley<real_fixed>(real_skew(5));
  expect_cayley<complex_fixed>(skew_hermitian(5));
}

// V is off by 1e-9: what is left of that is its square.
TEST(MatrixFunctions, AConjugationIsUnitary) {
  const complex_dense one = complex_dense::Identity(n, n), m = hermitian(6);
  const complex_dense v = exponential(0.1 * skew_hermitian(7)) - one, off = v + 1e-9 * hermitian(8);
  const complex_dense u = one + v;
  const auto found = dense(conjugation(of<complex_fixed>(off), of<complex_fixed>(m)));
  EXPECT_LE((found - (u.adjoint() * m * u - m)).norm(), 1e-8);  // U itself is another by so much
  const auto eigenvalues = [](const complex_dense& a) { return symmetric_eigenpairs_of(real_form(a)).values; };
  EXPECT_LE((eigenvalues(m + found) - eigenvalues(m)).norm(), 1e-14 * m.norm());
}

// The same of real skew matrices.
TEST(MatrixFunctions, ASkewConjugationIsOrthogonal) {
  const complex_dense m = real_skew(6), one = complex_dense::Identity(n, n);
  const complex_dense off =
      exponential(0.3 * real_skew(7)) - one + 1e-9 * complex_numbers(8).real().cast<std::complex<double>>();
  const auto found = dense(skew_conjugation(of<real_fixed>(off), of<real_fixed>(m)));
  const auto squares = [](const complex_dense& a) {
    return symmetric_eigenpairs_of(real_form(a.adjoint() * a)).values;
  };
  EXPECT_LE((squares(m + found) - squares(m)).norm(), 1e-14 * m.squaredNorm());
}

TEST(SkewProjection, HasTheEigenvaluesOfTheOther) {
  for (const double away : {1e-6, 1e-3, 0.05}) {
    const Eigen::MatrixXd x = real_skew(9).real(), onto = x + away * real_skew(10).real();
    const complex_dense given = x.cast<std::complex<double>>(), way = (onto - x).cast<std::complex<double>>();
    const auto added = dense(skew_projection(of<real_fixed>(given), of<real_fixed>(given + way), of<real_fixed>(way)));
    const Eigen::MatrixXd found = x + added.real();
    EXPECT_LE((found + found.transpose()).norm(), 1e-15);
    const auto square_of = [](const Eigen::MatrixXd& a) { return symmetric_eigenpairs_of(a * a.transpose()).values; };
    EXPECT_LE((square_of(found) - square_of(onto)).norm(), 1e-13 * square_of(onto).norm()) << away;
    EXPECT_GE((square_of(x) - square_of(onto)).norm(), 0.1 * away);
    EXPECT_LE(added.norm(), 10 * away);
    EXPECT_LE((found * x - x * found).norm(), 1e-13 * x.squaredNorm());  // M times a polynomial of M^T M
  }
}

// Of any size: a corrected step of a body a thousandth as large is a thousandth as large.
TEST(SkewProjection, ScalesWithTheMatrix) {
  const complex_dense x = real_skew(9), way = 0.05 * real_skew(10);
  const auto added_of = [&](double scale) {
    return dense(
        skew_projection(of<real_fixed>(scale * x), of<real_fixed>(scale * (x + way)), of<real_fixed>(scale * way)));
  };
  EXPECT_LE((1e3 * added_of(1e-3) - added_of(1)).norm(), 1e-14);
}

/// Of any number of rows.
template <int rows>
fixed_matrix<double, rows> fixed_of(const Eigen::MatrixXd& a) {
  fixed_matrix<double, rows> out;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < rows; ++j) out(i, j) = a(i, j);
  return out;
}
Eigen::MatrixXd skew_of_six(unsigned seed) {
  const Eigen::MatrixXd a = complex_numbers(seed).real(), b = complex_numbers(seed + 1).imag(),
                        beside = complex_numbers(seed + 2).real();
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(6, 6);
  out.topLeftCorner(4, 4) = a - a.transpose();
  out.topRightCorner(4, 2) = b.leftCols(2);
  out.bottomLeftCorner(2, 4) = -b.leftCols(2).transpose();
  out(4, 5) = beside(0, 0);
  out(5, 4) = -beside(0, 0);
  return out;
}

TEST(SkewProjection, AsksForTheDifferencesOfTheTraces) {
  const Eigen::MatrixXd x = skew_of_six(11), onto = skew_of_six(21), p = x.transpose() * x, q = onto.transpose() * onto;
  const auto from = fixed_of<6>(x), to = fixed_of<6>(onto);
  const auto changes = detail::trace_changes(detail::skew_powers<3>(from), detail::skew_powers<3>(to),
                                             fixed_of<6>(onto - x), fixed_of<6>(onto + x));
  const double expected[] = {(q - p).trace() / 2, (q * q - p * p).trace() / 2, (q * q * q - p * p * p).trace() / 2};
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(changes[k], expected[k], 1e-13 * (q * q * q + p * p * p).trace());
}

// q_k = (a^k + b^k)/2 + … of P with the eigenvalues a and b, two of each. dc moves |M| by sum |q_k dc_k| / q_1 of it.
TEST(SkewProjection, TakesNoCorrectionOfMoreThanTenTimesTheMatrixButScalesIt) {
  const double a = 0.7, b = 0.4, ratio = -1.7;  // of dc_1 and dc_0
  vec<double, 4> q;
  for (int k = 0; k < 4; ++k) q[k] = std::pow(a, k + 1) + std::pow(b, k + 1);
  for (const double size : {0.3, 9.995, 10.005}) {
    const double c0 = size / (1 + std::fabs(ratio) * q[1] / q[0]), c1 = ratio * c0;
    const vec<double, 2> change{{2 * (q[0] * c0 + q[1] * c1), 4 * (q[1] * c0 + q[2] * c1)}};
    const auto found = detail::orbit_correction_of<double, 2>(q, change);
    EXPECT_NEAR(found.size, size, 1e-12);
    EXPECT_NEAR(found.c[0], size < 10 ? c0 : change[0] / (2 * q[0]), 1e-12);
    EXPECT_NEAR(found.c[1], size < 10 ? c1 : 0, 1e-12);
  }
}

TEST(SkewProjection, OfWhatIsOnTheOrbitAddsNothing) {
  const auto x = of<real_fixed>(real_skew(9));
  EXPECT_EQ(dense(skew_projection(x, x, 0.0 * x)).norm(), 0);
}

// By Newton's method a third of a length becomes 5/3, 17/15, …: the sixth correction is the first to leave nothing.
TEST(SkewProjection, ReachesThreeTimesTheLength) {
  const Eigen::Matrix3d x = real_skew(9).real().topLeftCorner(3, 3);
  const auto added = skew_projection(fixed_of<3>(x), fixed_of<3>(3 * x), fixed_of<3>(2 * x));
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(added(i, j), 2 * x(i, j), 1e-14);
}

}  // namespace
}  // namespace polhode
