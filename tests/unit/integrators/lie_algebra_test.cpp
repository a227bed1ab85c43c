// SPDX-License-Identifier: Apache-2.0
// What every Lie algebra of lie/ must do, against matrices. A new one adds its name and a state.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include <polhode/dual.hpp>
#include <polhode/lie/se2.hpp>
#include <polhode/lie/se3.hpp>
#include <polhode/lie/so3_power.hpp>
#include <polhode/lie/so4.hpp>
#include <polhode/lie/son.hpp>
#include <polhode/lie/su.hpp>
#include <polhode/simd.hpp>

#include "support/dense.hpp"
#include "support/schemes.hpp"

namespace polhode::test {
namespace {

template <class Algebra, int components = Algebra::dimension>
struct on {
  using algebra = Algebra;
  using element = vec<double, Algebra::dimension>;
  static constexpr int n = components;
  static constexpr bool by_matrices = std::is_same_v<Algebra, son> || std::is_same_v<Algebra, su>;
  static constexpr double dexp_inv_reach = by_matrices ? 0.6 : 5;  ///< a series, or a closed form

  static element of(const vec<double, n>& numbers) {
    auto out = zeros<element>(n);
    for (int k = 0; k < n; ++k) out[k] = numbers[k];
    return out;
  }
  /// Of a length that is no more than the largest angle.
  static element some(std::uint64_t i, double size) {
    const auto v = normals<n>({12, noise_kind::initial_state, i, 0});
    return size / std::sqrt(dot(v, v)) * of(v);
  }
  static element state() { return some(99, 1.3); }
  static Eigen::VectorXd numbers(const element& v) { return Eigen::Map<const Eigen::VectorXd>(v.begin(), n); }
  static Eigen::MatrixXd coad_matrix(const element& xi) {
    Eigen::MatrixXd m(n, n);
    for (int k = 0; k < n; ++k) {
      auto e = zeros<element>(n);
      e[k] = 1;
      m.col(k) = numbers(Algebra::coad(xi, e));
    }
    return m;
  }
  /// What a change of each Casimir is measured by.
  static auto casimir_sizes(const element& mu) {
    if constexpr (requires { Algebra::casimir_sizes(mu); })
      return Algebra::casimir_sizes(mu);
    else
      return Algebra::casimirs(mu);
  }
  static double distance(const element& a, const Eigen::VectorXd& b) { return (numbers(a) - b).norm(); }
  static double distance(const element& a, const element& b) { return distance(a, numbers(b)); }
};

template <class On>
struct LieAlgebra : testing::Test {};
using every_algebra = testing::Types<on<so3>, on<so4>, on<so3_power<16>, 9>, on<se2>, on<se3>, on<son, 3>, on<son, 6>,
                                     on<son, 10>, on<son, 15>, on<su, 8>, on<su, 24>>;
TYPED_TEST_SUITE(LieAlgebra, every_algebra);

constexpr double element_sizes[] = {0.0, 1e-300, 1e-12, 1e-6, 1e-3, 0.199, 0.201, 1.0, 3.0, 10.0};

TYPED_TEST(LieAlgebra, ExponentialActionIsTheMatrixExponential) {
  using on = TypeParam;
  for (const double size : element_sizes)
    for (std::uint64_t i = 0; i < 10; ++i) {
      const auto xi = on::some(i, size);
      const Eigen::VectorXd expected = exponential_of(on::coad_matrix(xi)) * on::numbers(on::state());
      EXPECT_LE(on::distance(on::algebra::exp_action(xi, on::state()), expected), 2e-14 * std::max(1.0, size));
    }
}

TYPED_TEST(LieAlgebra, CayleyActionIsTheCayleyTransform) {
  using on = TypeParam;
  if (on::by_matrices && on::n > 3) return;  // another one: OfMatricesIsByAnOrthogonalMatrix
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(on::n, on::n);
  for (const double size : element_sizes)
    for (std::uint64_t i = 0; i < 10; ++i) {
      const Eigen::MatrixXd half = 0.5 * on::coad_matrix(on::some(i, size));
      const Eigen::VectorXd expected = solution_of(one - half, (one + half) * on::numbers(on::state()));
      EXPECT_LE(on::distance(on::algebra::cayley_action(on::some(i, size), on::state()), expected),
                2e-14 * std::max(1.0, size));
    }
}

TYPED_TEST(LieAlgebra, ActionsKeepTheCasimirs) {
  using on = TypeParam;
  using algebra = typename on::algebra;
  const auto casimirs = algebra::casimirs(on::state()), size_of = on::casimir_sizes(on::state());
  for (const double size : element_sizes)
    for (std::uint64_t i = 0; i < 10; ++i)
      for (const auto& next : {algebra::exp_action(on::some(i, size), on::state()),
                               algebra::cayley_action(on::some(i, size), on::state())})
        for (int k = 0; k < casimirs.size; ++k)
          EXPECT_LE(std::fabs(algebra::casimirs(next)[k] - casimirs[k]), 1e-15 * std::max(4.0, size) * size_of[k])
              << size;
}

TYPED_TEST(LieAlgebra, BracketIsTheCommutatorOfCoadjointOperatorsInItsOrder) {
  using on = TypeParam;
  using algebra = typename on::algebra;
  const auto x = on::some(1, 0.7), y = on::some(2, 1.3), mu = on::state();
  const auto commutator = algebra::coad(y, algebra::coad(x, mu)) - algebra::coad(x, algebra::coad(y, mu));
  EXPECT_LE(on::distance(commutator, algebra::coad(algebra::bracket(x, y), mu)), 1e-14);
}

TYPED_TEST(LieAlgebra, BracketObeysJacobi) {
  using on = TypeParam;
  const auto b = [](const auto& x, const auto& y) { return on::algebra::bracket(x, y); };
  const auto x = on::some(1, 0.7), y = on::some(2, 1.3), z = on::some(3, 0.9);
  const auto sum = b(x, b(y, z)) + b(y, b(z, x)) + b(z, b(x, y));
  EXPECT_LE(on::numbers(sum).norm(), 1e-15);
}

/// d/dt exp(C(u + t w)) at t = 0 equals C(v) exp(C(u)) where w = dexp_inv(-u, v).
TYPED_TEST(LieAlgebra, DexpInvInvertsTheDifferentialOfTheAction) {
  using on = TypeParam;
  using algebra = typename on::algebra;
  for (const double size : {1e-9, 1e-3, 0.1, 0.19, 0.21, 1.0, 3.0, 5.0}) {
    if (size > on::dexp_inv_reach) continue;
    const auto u = on::some(3, size), v = on::some(4, 1.0), w = algebra::dexp_inv(-u, v);
    constexpr double h = 1e-4;
    const auto at = [&](double t) { return algebra::exp_action(u + t * w, on::state()); };
    const auto slope = (1 / (12 * h)) * (8.0 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h)));
    EXPECT_LE(on::distance(slope, algebra::coad(v, algebra::exp_action(u, on::state()))), 1e-9) << size;
  }
}

/// The sum of B_k/k! ad_u^k v, on both sides of the angle where the closed form takes over.
TYPED_TEST(LieAlgebra, DexpInvIsItsSeries) {
  using on = TypeParam;
  using algebra = typename on::algebra;
  const double b[] = {-0.5, 1.0 / 12, 0, -1.0 / 720, 0, 1.0 / 30240, 0, -1.0 / 1209600, 0, 1.0 / 47900160};
  for (const double size : {0.0, 1e-6, 0.1, 0.2 - 1e-9, 0.2 + 1e-9}) {
    const auto u = on::some(5, size), v = on::some(6, 1.0);
    auto sum = v, term = v;
    for (const double coefficient : b) {
      term = algebra::bracket(u, term);
      sum = sum + coefficient * term;
    }
    EXPECT_LE(on::distance(algebra::dexp_inv(u, v), sum), 2e-15) << size;
  }
}

/// As far as its series is used: B_2k / (2k)! = 2 (-1)^(k+1) zeta(2k) / (2 pi)^2k, to k = 15.
TYPED_TEST(LieAlgebra, DexpInvIsItsSeriesAsFarAsThatReaches) {
  using on = TypeParam;
  using algebra = typename on::algebra;
  const auto u = on::some(5, 0.6), v = on::some(6, 1.0);
  auto term = algebra::bracket(u, v);
  auto sum = v - 0.5 * term;
  double power = 1;
  for (int k = 1; k <= 15; ++k) {
    power /= -4 * std::numbers::pi * std::numbers::pi;
    term = algebra::bracket(u, term);
    sum = sum + (-2 * power * std::riemann_zeta(2.0 * k)) * term;
    term = algebra::bracket(u, term);
  }
  EXPECT_LE(on::distance(algebra::dexp_inv(u, v), sum), 1e-13);
}

TYPED_TEST(LieAlgebra, ProjectionPutsAStateBackOntoItsOrbit) {
  using on = TypeParam;
  using algebra = typename on::algebra;
  const auto orbit = algebra::casimirs(on::state()), size_of = on::casimir_sizes(on::state());
  for (const double far : {1e-12, 0.01, 0.5, 1e9}) {
    if (on::by_matrices && far > 0.1) continue;
    const auto back = algebra::orbit_projection(on::state() + on::some(7, far), on::state());
    const auto size_there = on::casimir_sizes(back);  // what is not turned back may be as large
    for (int k = 0; k < orbit.size; ++k)
      EXPECT_NEAR(algebra::casimirs(back)[k], orbit[k], 4e-15 * std::max(size_of[k], size_there[k])) << far;
    EXPECT_LE(on::distance(back, on::state()), 3 * far + 1e-15);
  }
  EXPECT_LE(on::distance(algebra::orbit_projection(on::state(), on::state()), on::state()), 5e-16);
}

TYPED_TEST(LieAlgebra, ProjectionOfDualsIsItsDerivative) {
  using on = TypeParam;
  using algebra = typename on::algebra;
  const auto mu = on::state() + on::some(7, 0.05), onto = on::state(), a = on::some(8, 1.0), b = on::some(9, 1.0);
  auto from = zeros<vec<dual<double, 1>, algebra::dimension>>(on::n), to = from;
  for (int k = 0; k < on::n; ++k) {
    from[k] = {mu[k], {{a[k]}}};
    to[k] = {onto[k], {{b[k]}}};
  }
  constexpr double h = 1e-3;
  const auto at = [&](double t) { return algebra::orbit_projection(mu + t * a, onto + t * b); };
  const auto slope = (1 / (12 * h)) * (8.0 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h)));
  const auto found = algebra::orbit_projection(from, to);
  for (int k = 0; k < on::n; ++k) EXPECT_NEAR(found[k].slope[0], slope[k], 1e-8) << k;
}

/// Of a vector above the diagonal.
Eigen::MatrixXd skew(const vec<double, son::dimension>& v) {
  const auto m = son::as_matrix(v);
  Eigen::MatrixXd out(m.n, m.n);
  for (int i = 0; i < m.n; ++i)
    for (int j = 0; j < m.n; ++j) out(i, j) = m(i, j);
  return out;
}

TEST(Son, CayleyActionIsByAnOrthogonalMatrix) {
  using six = on<son, 15>;
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(6, 6), m = skew(six::state());
  for (const double size : element_sizes) {
    const Eigen::MatrixXd x = 0.5 * skew(six::some(1, size)), r = solution_of(one - x, one + x);
    EXPECT_LE((skew(son::cayley_action(six::some(1, size), six::state())) - r.transpose() * m * r).norm(), 1e-13);
  }
}

/// M = mu^.
TEST(Son, OfThreeRowsIsSo3) {
  using three = on<son, 3>;
  const auto hat = [](const vec<double, 3>& v) { return three::of({{-v[2], v[1], -v[0]}}); };
  const vec<double, 3> mu{{0.6, 0.48, 0.64}};
  for (const double size : {1e-6, 0.3, 2.0}) {
    const auto xi = size * normals<3>({12, noise_kind::initial_state, 1, 0});
    EXPECT_LE(three::distance(son::coad(hat(xi), hat(mu)), hat(so3::coad(xi, mu))), 1e-15 * std::max(1.0, size));
    EXPECT_LE(three::distance(son::exp_action(hat(xi), hat(mu)), hat(so3::exp_action(xi, mu))), 4e-15);
    EXPECT_LE(three::distance(son::cayley_action(hat(xi), hat(mu)), hat(so3::cayley_action(xi, mu))), 4e-15);
    EXPECT_LE(three::distance(son::bracket(hat(xi), hat(mu)), hat(so3::bracket(xi, mu))), 1e-15 * std::max(1.0, size));
  }
  EXPECT_NEAR(son::casimirs(hat(mu))[0], so3::casimirs(mu)[0], 1e-15);
}

/// sum_k v_k J_k by products of Sylvester's clock and shift, J_k = e^{k_1 k_2 / 2} clock^k_1 shift^k_2, e = exp(4 pi
/// i/n).
template <int components>
Eigen::MatrixXcd by_clock_and_shift(const vec<double, su::dimension>& v) {
  using namespace std::complex_literals;
  const int n = su::rows_of(components);
  Eigen::MatrixXcd clock = Eigen::MatrixXcd::Zero(n, n), shift = clock, out = clock;
  for (int a = 0; a < n; ++a) {
    clock(a, a) = std::exp(4i * M_PI * double(a) / double(n));
    shift(a, (a + 1) % n) = 1;
  }
  int place = 0;
  for (int k1 = 0; k1 <= n / 2; ++k1)
    for (int k2 = -(n / 2); k2 <= n / 2; ++k2) {
      if (k1 == 0 && k2 <= 0) continue;
      Eigen::MatrixXcd j = std::exp(2i * M_PI * double(k1 * k2) / double(n)) * Eigen::MatrixXcd::Identity(n, n);
      for (int i = 0; i < k1; ++i) j *= clock;
      for (int i = 0; i < (k2 + n) % n; ++i) j *= shift;
      const auto mode = (v[place] + 1i * v[place + 1]) / std::sqrt(2.0);
      out += mode * j + std::conj(mode) * j.adjoint();
      place += 2;
    }
  return out;
}

template <int components>
void expect_conjugation() {
  using on = on<su, components>;
  const double n = su::rows_of(components);
  const auto matrix = by_clock_and_shift<components>;
  const auto h = matrix(on::state());
  const auto casimirs = su::casimirs(on::state()), size_of = su::casimir_sizes(on::state());
  EXPECT_NEAR(casimirs[0], std::sqrt((h * h).trace().real() / n), 1e-14);
  Eigen::MatrixXcd power = h * h;
  for (int j = 3; j <= n; ++j) {
    power *= h;
    EXPECT_NEAR(casimirs[j - 2], power.trace().real() / n, 1e-14 * size_of[j - 2]) << j;
  }
  const Eigen::MatrixXcd one = Eigen::MatrixXcd::Identity(h.rows(), h.cols());
  for (const double size : element_sizes) {
    const auto xi = on::some(1, size);
    const Eigen::MatrixXcd x = std::complex(0.0, n / (8 * M_PI)) * matrix(xi),
                           u = complex_form(solution_of(real_form(one - x), real_form(one + x)));
    EXPECT_LE((matrix(su::cayley_action(xi, on::state())) - u.adjoint() * h * u).norm(), 1e-13) << size;
  }
}

TEST(Su, ActsByConjugationOfComplexMatrices) {
  expect_conjugation<8>();
  expect_conjugation<24>();
}

/// The same rounding step after step would let the orbit drift like the number of steps, here by 1e-13.
TEST(Su, ProjectionsOfManyStepsDoNotLeaveTheOrbit) {
  using three = on<su, 8>;
  const auto orbit = su::casimirs(three::state()), size_of = su::casimir_sizes(three::state());
  auto mu = three::state();
  for (std::uint64_t i = 0; i < 100'000; ++i) {
    const auto xi = three::some(i, 0.1), first = su::coad(xi, mu);
    mu = su::orbit_projection(mu + 0.5 * (first + su::coad(xi, mu + first)), mu);
  }
  for (int k = 0; k < orbit.size; ++k) EXPECT_NEAR(su::casimirs(mu)[k], orbit[k], 4e-14 * size_of[k]) << k;
}

TEST(Son, ProjectionsOfManyStepsDoNotLeaveTheOrbit) {
  using five = on<son, 10>;
  const auto orbit = son::casimirs(five::state());
  auto mu = five::state();
  for (std::uint64_t i = 0; i < 100'000; ++i) {
    const auto xi = five::some(i % 16, 0.02), first = son::coad(xi, mu);
    mu = son::orbit_projection(mu + 0.5 * (first + son::coad(xi, mu + first)), mu);
  }
  for (int k = 0; k < orbit.size; ++k) EXPECT_NEAR(son::casimirs(mu)[k], orbit[k], 4e-14 * orbit[k]) << k;
}

/// A lane's own number of squarings.
TEST(Son, LanesDoNotSeeEachOther) {
  using three = on<son, 6>;
  using packs = vec<pack, son::dimension>;
  packs xi(6), mu(6);
  for (int k = 0; k < 6; ++k) {
    xi[k] = pack([&](auto lane) {
      return std::ldexp(three::some(static_cast<std::uint64_t>(lane), 1)[k], 2 * static_cast<int>(lane) - 4);
    });
    mu[k] = three::state()[k];
  }
  const auto all = son::exp_action(xi, mu);
  for (std::size_t lane = 0; lane < pack::size(); ++lane) {
    auto own = zeros<three::element>(6);
    for (int k = 0; k < 6; ++k) own[k] = xi[k][lane];
    const auto alone = son::exp_action(own, three::state());
    for (int k = 0; k < 6; ++k) EXPECT_NEAR(all[k][lane], alone[k], 1e-13) << lane;
  }
}

}  // namespace
}  // namespace polhode::test
