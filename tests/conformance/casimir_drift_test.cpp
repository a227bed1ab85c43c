// SPDX-License-Identifier: Apache-2.0
// What one step does to the Casimirs: nothing beyond rounding, or as much as drifts over a fixed time at the order that
// the scheme claims.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "support/mean_over_increments.hpp"
#include "support/schemes.hpp"

namespace polhode::test {
namespace {

/// Of one step: mean and root mean square, of the Casimir that changes more.
struct change {
  double mean, rms;
};
template <class Scheme, class System>
change change_of_casimirs(const System& system, const state_of<System>& mu, double dt, const std::vector<int>& acting) {
  const auto before = System::algebra::casimirs(mu);
  const auto stepped = prepared<Scheme>(system, dt);
  change out{};
  for (int k = 0; k < before.size; ++k) {
    const auto gained = [&](const auto& w) {
      return System::algebra::casimirs(Scheme::step(stepped, mu, w))[k] - before[k];
    };
    const auto mean = [&](const auto& f) { return mean_over_increments<System::channels>(dt, acting, f); };
    out.mean = std::max(out.mean, std::fabs(mean(gained)));
    out.rms = std::max(out.rms, std::sqrt(mean([&](const auto& w) { return gained(w) * gained(w); })));
  }
  return out;
}

/// 1 / dt steps: means add up, and deviations as the root of their number.
template <class Scheme, class System>
double order_of_drift(const System& system, const state_of<System>& mu, double dt, const std::vector<int>& acting) {
  const auto coarse = change_of_casimirs<Scheme>(system, mu, dt, acting);
  const auto fine = change_of_casimirs<Scheme>(system, mu, dt / 16, acting);
  return std::min(std::log2(coarse.mean / fine.mean) / 4 - 1, std::log2(coarse.rms / fine.rms) / 4 - 0.5);
}

template <class Scheme, class System>
void expect_drift(const System& noisy, const System& quiet, const state_of<System>& mu) {
  constexpr casimir_claim claim = Scheme::info.casimir;
  std::vector<int> acting(System::channels);
  std::iota(acting.begin(), acting.end(), 0);
  if constexpr (claim.exact) {
    EXPECT_LT(change_of_casimirs<Scheme>(noisy, mu, 0x1p-6, acting).rms, 1e-14) << Scheme::info.name;
    EXPECT_LT(change_of_casimirs<Scheme>(quiet, mu, 0x1p-6, {}).rms, 1e-14) << Scheme::info.name;
  } else {
    EXPECT_NEAR(order_of_drift<Scheme>(noisy, mu, 0x1p-8, acting), claim.noisy_order, 0.03) << Scheme::info.name;
    const auto one = change_of_casimirs<Scheme>(quiet, mu, 0x1p-4, {}),
               other = change_of_casimirs<Scheme>(quiet, mu, 0x1p-8, {});
    EXPECT_NEAR(std::log2(one.mean / other.mean) / 4 - 1, claim.deterministic_order, 0.05) << Scheme::info.name;
  }
}

template <class Scheme>
struct CasimirDrift : testing::Test {};
TYPED_TEST_SUITE(CasimirDrift, every_scheme);

TYPED_TEST(CasimirDrift, IsOfTheOrderThatIsClaimed) {
  expect_drift<TypeParam>(paper_body(), paper_body(0.5, 0), paper_momentum);
  expect_drift<TypeParam>(coupled_bodies(), coupled_bodies(0.4, so4_body::matrix::Zero()),
                          vec<double, 6>{{0.6, 0.48, 0.64, -0.3, 0.8, 0.5}});
}

}  // namespace
}  // namespace polhode::test
