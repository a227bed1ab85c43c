// SPDX-License-Identifier: Apache-2.0
// One step against the true solution of the driven equation, path by path: its root mean square is of half an order
// more than the strong order that the scheme claims, neither less nor more, under any noise and under one vector.
#include <gtest/gtest.h>

#include <cmath>

#include <polhode/systems/varying_spin.hpp>

#include "references/wong_zakai_equation.hpp"
#include "support/schemes.hpp"

namespace polhode::test {
namespace {

/// Over a step whose noise is piecewise linear on cells: increments and areas of such a path are known, and
/// wong_zakai_equation's error on a cell is far below that of any scheme on all.
template <class Scheme, class System>
double local_error(const System& system, const state_of<System>& mu, double dt) {
  constexpr int paths = 64, cells = 16, channels = System::channels;
  const auto stepped = prepared<Scheme>(system, dt);
  double square = 0;
  for (std::uint64_t path = 0; path < paths; ++path) {
    wiener_levy<double, channels> whole;
    auto exact = mu;
    for (std::uint64_t cell = 0; cell < cells; ++cell) {
      wiener_levy<double, channels> piece;
      piece.dt = dt / cells;
      piece.dw = std::sqrt(piece.dt) * normals<channels>({7, noise_kind::increment, path, cell});
      exact = wong_zakai_equation::step(system, exact, piece);
      whole = chen(whole, piece);
    }
    square += std::pow(distance(Scheme::step(stepped, mu, whole), exact), 2) / paths;
  }
  return std::sqrt(square);
}

/// The same normals at every step size, so that the error is a series in the root of dt and the slope has no noise.
template <class Scheme, class System>
void expect_local_strong_order(const System& system, const state_of<System>& mu, double strong_order) {
  const double coarse = local_error<Scheme>(system, mu, 0x1p-10), fine = local_error<Scheme>(system, mu, 0x1p-14);
  EXPECT_NEAR(std::log2(coarse / fine) / 4, strong_order + 0.5, 0.03) << Scheme::info.name;
}

template <class Scheme>
struct LocalError : testing::Test {};
TYPED_TEST_SUITE(LocalError, every_scheme);

TYPED_TEST(LocalError, FallsAsTheStrongOrderSays) {
  const vec<double, 6> momentum{{0.6, 0.48, 0.64, -0.3, 0.8, 0.5}};
  expect_local_strong_order<TypeParam>(paper_body(), paper_momentum, TypeParam::info.strong_order.general);
  expect_local_strong_order<TypeParam>(coupled_bodies(), momentum, TypeParam::info.strong_order.general);
}

TYPED_TEST(LocalError, FallsAsTheStrongOrderSaysWhereNoiseCommutes) {
  const vec<double, 3> sigma[] = {{{0.3, 0.4, 0.5}}};
  const rigid_body body({1, 2, 3}, 0.5, rigid_body::from_vectors(sigma));
  expect_local_strong_order<TypeParam>(body, paper_momentum, TypeParam::info.strong_order.commuting);
}

/// A tilted spin in a field under vectors v_i that do not commute, or one.
varying_spin varying(state_noise form, int vectors) {
  const vec<double, 3> v[] = {{{0.3, 0.4, 0.5}}, {{-0.5, 0.2, 0.3}}, {{0.1, 0.6, -0.4}}};
  const Eigen::Matrix3d quadratic{{0.6, 0.1, 0}, {0.1, 0, 0}, {0, 0, -1.2}};
  return {spin(quadratic, {0.3, 0, 0.2}, 0.8, spin::from_vectors(std::span(v).first(std::size_t(vectors)))), form};
}

TYPED_TEST(LocalError, FallsAsTheStrongOrderSaysWhereNoiseDependsOnTheState) {
  if constexpr (scheme_on<TypeParam, varying_spin>) {
    for (const auto form : {state_noise::damped, state_noise::quadratic}) {
      expect_local_strong_order<TypeParam>(varying(form, 3), paper_momentum, TypeParam::info.strong_order.general);
      expect_local_strong_order<TypeParam>(varying(form, 1), paper_momentum, TypeParam::info.strong_order.commuting);
    }
  } else {
    EXPECT_TRUE(TypeParam::info.name == "lie_euler" || TypeParam::info.name == "strang_weak2" ||
                TypeParam::info.name == "strang_two_turns");
  }
}

/// As one is that brings no flow of its noise: the mean of both ends of a step is taken.
struct without_own_flow : varying_spin {
  explicit without_own_flow(const varying_spin& s) : varying_spin(s) {}
  void noise_flow(const vec<double, 3>&, const wiener<double, 3>&) const = delete;
};

template <class Scheme>
struct LocalErrorOfSplittings : testing::Test {};
using splittings = testing::Types<strang, lie_trotter>;
TYPED_TEST_SUITE(LocalErrorOfSplittings, splittings);

TYPED_TEST(LocalErrorOfSplittings, FallsAsTheStrongOrderSaysWithoutAFlowOfNoiseThatDependsOnTheState) {
  for (const auto form : {state_noise::damped, state_noise::quadratic}) {
    const without_own_flow many(varying(form, 3)), one(varying(form, 1));
    expect_local_strong_order<TypeParam>(many, paper_momentum, TypeParam::info.strong_order.general);
    expect_local_strong_order<TypeParam>(one, paper_momentum, TypeParam::info.strong_order.commuting);
  }
}

TEST(VaryingSpin, HasNoNoiseOneVectorOrNoiseThatDependsOnTheState) {
  for (const auto form : {state_noise::damped, state_noise::quadratic}) {
    EXPECT_EQ(varying(form, 0).classify(), noise_class::none);
    EXPECT_EQ(varying(form, 1).classify(), noise_class::one_vector);
    EXPECT_EQ(varying(form, 2).classify(), noise_class::state_dependent);
    EXPECT_EQ(varying(form, 3).classify(), noise_class::state_dependent);
  }
}

}  // namespace
}  // namespace polhode::test
