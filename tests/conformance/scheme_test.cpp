// SPDX-License-Identifier: Apache-2.0
// What every scheme must do, on every system that ships, for doubles and for packs.
#include <gtest/gtest.h>

#include <polhode/simd.hpp>

#include "references/odeint.hpp"
#include "support/dual_step.hpp"
#include "support/heavy_top.hpp"
#include "support/maxwell_bloch.hpp"
#include "support/schemes.hpp"
#include "support/spin.hpp"

namespace polhode::test {
namespace {

template <class Scheme>
struct SchemeConformance : testing::Test {};
TYPED_TEST_SUITE(SchemeConformance, every_scheme);

const vec<double, 6> so4_momentum{{0.6, 0.48, 0.64, -0.3, 0.8, 0.5}};

/// Of those that the scheme can run on.
template <class Scheme, class Test>
void on_every_system(Test test) {
  test(paper_body(), paper_momentum);
  test(coupled_bodies(), so4_momentum);
  test(tilted_spin(), paper_momentum);
  if constexpr (scheme_on<Scheme, heavy_top>) test(asymmetric_top(), top_state);
  if constexpr (scheme_on<Scheme, maxwell_bloch>) test(atoms_in_light(), paper_momentum);
}

template <class Scheme, class System>
void zero_increment_is_identity(const System& system, const state_of<System>& mu) {
  const auto next = Scheme::step(system, mu, wiener_levy<double, System::channels>{});
  EXPECT_LE(distance(next, mu), 4e-16) << Scheme::info.name;
}

TYPED_TEST(SchemeConformance, ZeroIncrementIsTheIdentity) {
  on_every_system<TypeParam>(
      [](const auto& system, const auto& mu) { zero_increment_is_identity<TypeParam>(system, mu); });
}

template <class Scheme, class System>
state_of<System> without_noise(const System& system, state_of<System> mu, double horizon, int steps) {
  wiener_levy<double, System::channels> w;
  w.dt = horizon / steps;
  const auto stepped = prepared<Scheme>(system, w.dt);
  for (int i = 0; i < steps; ++i) mu = Scheme::step(stepped, mu, w);
  return mu;
}

template <class System>
state_of<System> end_by_odeint(const System& system, const state_of<System>& mu, double t) {
  const auto end = solve_drift(
      [&](std::span<const double> x, std::span<double> out) {
        state_of<System> m;
        std::ranges::copy(x, m.c.begin());
        std::ranges::copy(System::algebra::coad(system.generator(m), m).c, out.begin());
      },
      mu.c, t);
  state_of<System> out;
  std::ranges::copy(end, out.c.begin());
  return out;
}

/// The error falls by 2^order between two step sizes: agreement with an independent solver, and the claim, in one.
template <class Scheme, class System>
void converges_to_odeint(System system, const state_of<System>& mu) {
  system = system.with_noise({});
  const auto truth = end_by_odeint(system, mu, 2.0);
  const double coarse = distance(without_noise<Scheme>(system, mu, 2.0, 400), truth);
  const double fine = distance(without_noise<Scheme>(system, mu, 2.0, 800), truth);
  EXPECT_LT(fine, 1e-2);
  EXPECT_NEAR(std::log2(coarse / fine), Scheme::info.deterministic_order, 0.1) << Scheme::info.name;
}

TYPED_TEST(SchemeConformance, WithoutNoiseConvergesToOdeintAtTheClaimedOrder) {
  on_every_system<TypeParam>([](const auto& system, const auto& mu) { converges_to_odeint<TypeParam>(system, mu); });
}

/// Largest relative change of a Casimir over some noisy steps.
template <class Scheme, class System>
double casimir_change(const System& system, const state_of<System>& mu) {
  const auto start = System::algebra::casimirs(mu);
  auto x = mu;
  for (std::uint64_t i = 0; i < 1000; ++i)
    x = Scheme::step(prepared<Scheme>(system, 0.05), x, some_increment<System::channels>(0.05, i));
  const auto end = System::algebra::casimirs(x);
  double worst = 0;
  for (int k = 0; k < end.size; ++k)
    worst = std::isfinite(end[k]) ? std::max(worst, std::fabs(end[k] / start[k] - 1)) : HUGE_VAL;
  return worst;
}

TYPED_TEST(SchemeConformance, CasimirsAreKeptIfAndOnlyIfClaimed) {
  on_every_system<TypeParam>([](const auto& system, const auto& mu) {
    const double change = casimir_change<TypeParam>(system, mu);
    if (TypeParam::info.casimir.exact)
      EXPECT_LT(change, 2e-13);
    else
      EXPECT_GT(change, 1e-4);
  });
}

template <class Scheme, class System>
void packs_agree(const System& system, const state_of<System>& mu) {
  const auto stepped = prepared<Scheme>(system, 0.02);
  auto scalar = mu;
  state_of<System, pack> packed;
  for (int k = 0; k < System::dimension; ++k) packed[k] = mu[k];
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const auto w = some_increment<System::channels>(0.02, i);
    wiener_levy<pack, System::channels> p;
    p.dt = w.dt;
    for (int k = 0; k < System::channels; ++k) p.dw[k] = w.dw[k];
    for (int k = 0; k < pairs_of<System::channels>; ++k) p.area[k] = w.area[k];
    scalar = Scheme::step(stepped, scalar, w);
    packed = Scheme::step(stepped, packed, p);
  }
  for (int k = 0; k < System::dimension; ++k)
    for (std::size_t lane = 0; lane < pack::size(); ++lane) EXPECT_NEAR(packed[k][lane], scalar[k], 1e-13);
}

TYPED_TEST(SchemeConformance, PacksAgreeWithDoublesOverAThousandSteps) {
  on_every_system<TypeParam>([](const auto& system, const auto& mu) { packs_agree<TypeParam>(system, mu); });
}

TYPED_TEST(SchemeConformance, DualNumbersGiveTheDerivative) {
  on_every_system<TypeParam>([](const auto& system, const auto& mu) {
    duals_give_the_derivative<TypeParam>(system, mu, some_increment<std::decay_t<decltype(system)>::channels>(0.1, 0));
  });
}

// That the order is as claimed with them and without: local_error_test.cpp.
TYPED_TEST(SchemeConformance, StatesItsNeedOfAreasByItsType) {
  constexpr bool claims_order_one = TypeParam::info.strong_order.general == 1.0;
  EXPECT_EQ((needs_areas_on<TypeParam, rigid_body>), claims_order_one);
}

TYPED_TEST(SchemeConformance, InfoIsComplete) {
  constexpr auto info = TypeParam::info;
  EXPECT_FALSE(info.name.empty());
  EXPECT_FALSE(info.title.empty());
  EXPECT_FALSE(info.source.empty());
  EXPECT_GE(info.strong_order.commuting, info.strong_order.general);
  EXPECT_GE(info.weak_order.isotropic, info.weak_order.general);
  EXPECT_GE(info.deterministic_order, 1);
}

/// An implicit step whose equation has no reachable solution is NaN in its lane and leaves the others alone.
TEST(ImplicitMidpoint, FailureIsDataInItsOwnLane) {
  if (pack::size() < 2) GTEST_SKIP() << "one lane";
  const auto system = paper_body(1e6);
  vec<pack, 3> mu;
  wiener<pack, 3> w;
  w.dt = 10;
  for (int k = 0; k < 3; ++k) {
    mu[k] = pack([&](auto lane) { return lane == 0 ? 0.0 : 1e3 * paper_momentum[k]; });
    w.dw[k] = 0.1 * (k + 1);
  }
  const auto next = implicit_midpoint::step(system, mu, w);
  EXPECT_EQ(next[0][0], 0.0);
  EXPECT_TRUE(std::isfinite(next[1][0]));
}

}  // namespace
}  // namespace polhode::test
