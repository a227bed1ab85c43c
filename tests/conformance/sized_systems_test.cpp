// SPDX-License-Identifier: Apache-2.0
// Systems whose number of components is known at run time alone do what those of a fixed size do: two spins as the pair
// of bodies, one as the spin, the body in three dimensions as the rigid body, that in four as a pair.
#include <gtest/gtest.h>

#include <polhode/integrate.hpp>
#include <polhode/systems/sine_euler.hpp>
#include <polhode/systems/son_body.hpp>
#include <polhode/systems/spins.hpp>

#include "references/wong_zakai_equation.hpp"
#include "support/dual_step.hpp"
#include "support/schemes.hpp"
#include "support/spin.hpp"

namespace polhode::test {
namespace {

using group = spins::group;
constexpr double coupling = 0.3, theta = 0.4, strength = 0.3;
const Eigen::Matrix3d quadratic{{1, 0.3, -0.2}, {0.3, -0.5, 0.1}, {-0.2, 0.1, 0.2}};
constexpr std::array<double, 3> field{0.3, -0.2, 0.5};

template <int Most, class V>
vec<double, Most> sized(const V& v) {
  vec<double, Most> out(v.size);
  for (int k = 0; k < v.size; ++k) out[k] = v[k];
  return out;
}

template <int M>
wiener_levy<double, spins::channels> sized(const wiener_levy<double, M>& w) {
  wiener_levy<double, spins::channels> out;
  out.dt = w.dt;
  out.dw = sized<spins::channels>(w.dw);
  out.area = sized<pairs_of<spins::channels>>(w.area);
  return out;
}

template <class System, int components>
auto sized_increment(std::uint64_t step) {
  const auto w = some_increment<components>(0.05, step);
  wiener_levy<double, System::channels> out;
  out.dt = w.dt;
  out.dw = sized<System::channels>(w.dw);
  out.area = sized<pairs_of<System::channels>>(w.area);
  return out;
}

spins two_spins() {
  const Eigen::Matrix3d inverse_inertia = Eigen::Vector3d(1, 1.0 / 2, 1.0 / 3).asDiagonal();
  return {inverse_inertia, {0, 0, 0}, Eigen::Matrix2d::Constant(coupling), theta, spins::isotropic(strength, 6)};
}
so4_body two_bodies() { return {{1, 2, 3, 1, 2, 3}, coupling, theta, so4_body::isotropic(strength)}; }

/// The greatest distance over so many steps.
template <class Scheme, class Fixed, class Sized, int N>
double apart(const Fixed& fixed, const Sized& open, vec<double, N> mu, double dt, int steps) {
  const auto fixed_now = prepared<Scheme>(fixed, dt);
  const auto open_now = prepared<Scheme>(open, dt);
  auto other = sized<group::dimension>(mu);
  double worst = 0;
  for (int i = 0; i < steps; ++i) {
    const auto w = some_increment<Fixed::channels>(dt, static_cast<std::uint64_t>(i));
    mu = Scheme::step(fixed_now, mu, w);
    other = Scheme::step(open_now, other, sized(w));
    for (int k = 0; k < N; ++k) worst = std::max(worst, std::fabs(mu[k] - other[k]));
  }
  return worst;
}

TEST(SizedPaths, HaveTheNoiseOfTheirAddress) {
  const vec<double, 6> start{{0.6, 0.48, 0.64, 0.64, 0.48, 0.6}};
  const auto one = integrate<lie_heun>(two_bodies(), start, 0.05, 20, {.seed = 3});
  const auto other = integrate<lie_heun>(two_spins(), sized<group::dimension>(start), 0.05, 20, {.seed = 3});
  for (int k = 0; k < 6; ++k) EXPECT_NEAR(one[k], other[k], 1e-13);
  EXPECT_GT(
      std::fabs(integrate<lie_heun>(two_spins(), sized<group::dimension>(start), 0.05, 20, {.seed = 4})[0] - one[0]),
      1e-3);
}

template <class Scheme>
struct SizedSystems : testing::Test {};
TYPED_TEST_SUITE(SizedSystems, every_scheme);

const vec<double, 6> pair_state{{0.6, 0.48, 0.64, -0.3, 0.8, 0.5}};

/// A splitting puts the bonds elsewhere: its one step differs by its local error.
TYPED_TEST(SizedSystems, TwoSpinsMoveAsThePairOfBodies) {
  if (TypeParam::info.name.find("strang") == 0 || TypeParam::info.name == "lie_trotter")
    EXPECT_LE(apart<TypeParam>(two_bodies(), two_spins(), pair_state, 1e-3, 1), 1e-8);
  else
    EXPECT_LE(apart<TypeParam>(two_bodies(), two_spins(), pair_state, 0.05, 200), 1e-12);
}

/// The same system in registers: one spin a part of so(4), in a field that is not along an axis.
TYPED_TEST(SizedSystems, TwoSpinsMoveAsThePairOfSpins) {
  const Eigen::Matrix2d exchange = Eigen::Matrix2d::Constant(coupling);
  const spin_pair fixed(quadratic, field, exchange, theta, spin_pair::isotropic(strength));
  const spins open(quadratic, field, exchange, theta, spins::isotropic(strength, 6));
  EXPECT_LE(apart<TypeParam>(fixed, open, pair_state, 0.05, 200), 1e-12);
}

TYPED_TEST(SizedSystems, DualNumbersGiveTheDerivative) {
  duals_give_the_derivative<TypeParam>(two_spins(), sized<spins::dimension>(pair_state), sized_increment<spins, 6>(0));
  duals_give_the_derivative<TypeParam>(son_body({2, 1, 0}, theta, son_body::isotropic(strength, 3)),
                                       sized<son_body::dimension>(paper_momentum), sized_increment<son_body, 3>(0));
}

/// So large an increment that repeating m = mu + 1/2 f(m) leads away: the slopes are the derivative there too, as the
/// value is the solution.
TEST(SizedMidpoints, DualNumbersGiveTheDerivativeOfLargeSteps) {
  const auto body = son_body({2, 1, 0}, theta, son_body::isotropic(strength, 3));
  auto w = sized_increment<son_body, 3>(0);
  for (int k = 0; k < w.dw.size; ++k) w.dw[k] = 12.0 * (k - 0.7);
  duals_give_the_derivative<implicit_midpoint>(body, sized<son_body::dimension>(paper_momentum), w);
  duals_give_the_derivative<isospectral_midpoint>(body, sized<son_body::dimension>(paper_momentum), w);
}

TYPED_TEST(SizedSystems, OneSpinMovesAsTheSpin) {
  const spin fixed(quadratic, field, theta, spin::isotropic(strength));
  const spins open(quadratic, field, Eigen::MatrixXd::Zero(1, 1), theta, spins::isotropic(strength, 3));
  if (TypeParam::info.name.find("strang") == 0 || TypeParam::info.name == "lie_trotter")
    EXPECT_LE(apart<TypeParam>(fixed, open, paper_momentum, 1e-3, 1), 1e-8);
  else
    EXPECT_LE(apart<TypeParam>(fixed, open, paper_momentum, 0.05, 200), 1e-12);
}

/// Pi as the matrix Pi^, entry by entry, and so the increments and areas of its channels.
vec<double, son::dimension> hat(const vec<double, 3>& v) {
  return sized<son::dimension>(vec<double, 3>{{-v[2], v[1], -v[0]}});
}
wiener_levy<double, son_body::channels> hat(const wiener_levy<double, 3>& w) {
  wiener_levy<double, son_body::channels> out;
  out.dt = w.dt;
  out.dw = hat(w.dw);
  out.area = sized<pairs_of<son_body::channels>>(vec<double, 3>{{w.area[2], -w.area[1], w.area[0]}});
  return out;
}

/// The planes (1,2), (1,3), (2,3) have the inertias 3, 2, 1. Splittings take the axes in another order.
TYPED_TEST(SizedSystems, TheBodyInThreeDimensionsIsTheRigidBody) {
  const rigid_body fixed({1, 2, 3}, theta, rigid_body::isotropic(strength));
  const son_body open({2, 1, 0}, theta, son_body::isotropic(strength, 3));
  const bool splits = TypeParam::info.name.find("strang") == 0 || TypeParam::info.name == "lie_trotter";
  const double dt = splits ? 1e-3 : 0.05;
  const auto fixed_now = prepared<TypeParam>(fixed, dt);
  const auto open_now = prepared<TypeParam>(open, dt);
  auto mu = paper_momentum;
  auto other = hat(mu);
  for (std::uint64_t i = 0; i < (splits ? 1 : 200); ++i) {
    const auto w = some_increment<3>(dt, i);
    mu = TypeParam::step(fixed_now, mu, w);
    other = TypeParam::step(open_now, other, hat(w));
    const auto expected = hat(mu);
    for (int k = 0; k < 3; ++k) ASSERT_NEAR(other[k], expected[k], splits ? 1e-8 : 1e-12) << i;
  }
}

/// so(4) = so(3) + so(3): with L = (-M_23, M_13, -M_12) and K = (M_14, M_24, M_34) as parts a = (L + K)/2, b = (L -
/// K)/2 of a momentum, and as their sum and difference of an element of the algebra.
vec<double, son::dimension> from_parts(const vec<double, 3>& l, const vec<double, 3>& k) {
  return sized<son::dimension>(vec<double, 6>{{-l[2], l[1], k[0], -l[0], k[1], k[2]}});
}
vec<double, son::dimension> momentum_of(const vec<double, 6>& ab) {
  return from_parts(so4::part(ab, 0) + so4::part(ab, 1), so4::part(ab, 0) - so4::part(ab, 1));
}
vec<double, son::dimension> element_of_algebra(const vec<double, 6>& ab) {
  return from_parts(0.5 * (so4::part(ab, 0) + so4::part(ab, 1)), 0.5 * (so4::part(ab, 0) - so4::part(ab, 1)));
}

/// lambda = (1, 1, 1, 3): planes without axis 4 have inertia 2, those with it 4.
template <class Scheme>
double apart_in_four_dimensions() {
  constexpr double dt = 0.05;
  const so4_body fixed({4.0 / 3, 4.0 / 3, 4.0 / 3, 4.0 / 3, 4.0 / 3, 4.0 / 3}, 0.25, 2 * theta,
                       so4_body::isotropic(std::sqrt(2.0) * strength));
  const son_body open({1, 1, 1, 3}, theta, son_body::isotropic(strength, 6));
  auto mu = pair_state;
  auto other = momentum_of(mu);
  double worst = 0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    const wiener<double, 6> w = some_increment<6>(dt, i);
    mu = Scheme::step(fixed, mu, w);
    other =
        Scheme::step(open, other, wiener<double, son_body::channels>{dt, std::sqrt(2.0) * element_of_algebra(w.dw)});
    const auto expected = momentum_of(mu);
    for (int k = 0; k < 6; ++k) worst = std::max(worst, std::fabs(other[k] - expected[k]));
  }
  return worst;
}

/// Of all Casimirs, relative to their sizes, over a thousand noisy steps.
template <class Scheme, int components, class System>
void expect_casimirs_as_claimed(const System& system, double size) {
  using algebra = typename System::algebra;
  const auto stepped = prepared<Scheme>(system, 0.05);
  vec<double, System::dimension> start(components);
  for (int k = 0; k < start.size; ++k) start[k] = size * normals<components>({5, noise_kind::initial_state, 0, 0})[k];
  auto mu = start;
  for (std::uint64_t i = 0; i < 1000; ++i) mu = Scheme::step(stepped, mu, sized_increment<System, components>(i));
  const auto before = algebra::casimirs(start), after = algebra::casimirs(mu);
  const auto size_of = [&] {
    if constexpr (requires { algebra::casimir_sizes(start); })
      return algebra::casimir_sizes(start);
    else
      return before;
  }();
  for (int k = 0; k < before.size; ++k)
    if (Scheme::info.casimir.exact)
      EXPECT_LE(std::fabs(after[k] - before[k]), 1e-12 * size_of[k]) << k;
    else
      EXPECT_FALSE(std::fabs(after[k] - before[k]) < 1e-4 * size_of[k]) << k;
}

TYPED_TEST(SizedSystems, TheBodyInSixDimensionsKeepsItsCasimirsIfAndOnlyIfClaimed) {
  expect_casimirs_as_claimed<TypeParam, 15>(son_body({1, 1.4, 0.7, 2, 1.2, 0.9}, 0.3, son_body::isotropic(0.2, 15)),
                                            0.4);
}
TYPED_TEST(SizedSystems, TheFluidOnTheTorusKeepsItsCasimirsIfAndOnlyIfClaimed) {
  if constexpr (scheme_on<TypeParam, sine_euler>)
    expect_casimirs_as_claimed<TypeParam, 24>(sine_euler(5, 0.1, sine_euler::isotropic(0.1, 24)), 0.3);
}

TEST(SizedReference, TheBodyInFourDimensionsIsAPairOfBodies) {
  EXPECT_LE(apart_in_four_dimensions<heun>(), 1e-12);
  EXPECT_LE(apart_in_four_dimensions<lie_heun>(), 1e-12);
  EXPECT_LE(apart_in_four_dimensions<euler_maruyama>(), 1e-12);
}

TEST(SizedReference, MovesTwoSpinsAsThePairOfBodies) {
  EXPECT_LE(apart<wong_zakai_equation>(two_bodies(), two_spins(), pair_state, 0.05, 200), 1e-12);
}

TEST(SizedNoise, ClassesAreTheSame) {
  const auto of = [](const std::vector<std::vector<double>>& list) { return spins::from_vectors(list, 6).classify(); };
  EXPECT_EQ(of({}), noise_class::none);
  EXPECT_EQ(of({{0, 1, 0, 0, 0, 2}}), noise_class::one_vector);
  EXPECT_EQ(of({{0, 1, 0, 0, 0, 2}, {1, 0, 0, 0, 0, 0}}), noise_class::general);
  EXPECT_EQ(spins::isotropic(0.3, 6).classify(), noise_class::isotropic);
  EXPECT_EQ(spins::from_vectors(std::vector<std::vector<double>>{}, 6).active_channels(), 0);
  EXPECT_EQ(spins::isotropic(0.3, 6).active_channels(), 6);
}

/// More vectors than components become a square root of their covariance.
TEST(SizedNoise, ManyVectorsKeepTheirCovariance) {
  std::vector<std::vector<double>> list;
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(6, 6);
  for (std::uint64_t i = 0; i < 9; ++i) {
    const auto v = normals<6>({3, noise_kind::initial_state, i, 0});
    list.emplace_back(v.begin(), v.end());
    const Eigen::Map<const Eigen::VectorXd> e(list.back().data(), 6);
    covariance += e * e.transpose();
  }
  const auto noise = spins::from_vectors(list, 6);
  EXPECT_LE((noise.sigma() * noise.sigma().transpose() - covariance).norm(), 1e-12 * covariance.norm());
}

}  // namespace
}  // namespace polhode::test
