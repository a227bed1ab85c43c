// SPDX-License-Identifier: Apache-2.0
// Steps with dual numbers.
#pragma once

#include <gtest/gtest.h>

#include <polhode/dual.hpp>
#include <polhode/schemes/scheme_info.hpp>

namespace polhode::test {

/// The step with dual numbers against differences of the step with doubles, along two tangents of the orbit at once,
/// and its value against that step.
template <class Scheme, class System>
void duals_give_the_derivative(const System& system, const state_of<System>& mu,
                               const wiener_levy<double, System::channels>& w) {
  using number = dual<double, 2>;
  constexpr double h = 1e-5;
  const auto stepped = prepared<Scheme>(system, w.dt);
  wiener_levy<number, System::channels> constant;
  constant.dt = w.dt;
  constant.dw = constant_of<number>(w.dw);
  constant.area = constant_of<number>(w.area);
  const auto tangent = [&](int of) {
    auto xi = mu;
    for (int k = 0; k < mu.size; ++k) xi[k] = 0.5 - 0.3 * ((k + of) % 3);
    return System::algebra::coad(xi, mu);
  };
  auto x = constant_of<number>(mu);
  for (int t = 0; t < 2; ++t)
    for (int k = 0; k < mu.size; ++k) x[k].slope[t] = tangent(t)[k];
  x = Scheme::step(stepped, x, constant);
  const auto here = Scheme::step(stepped, mu, w);
  for (int k = 0; k < mu.size; ++k) EXPECT_NEAR(x[k].value, here[k], 1e-14) << Scheme::info.name << ' ' << k;
  for (int t = 0; t < 2; ++t) {
    const auto ahead = Scheme::step(stepped, mu + h * tangent(t), w),
               behind = Scheme::step(stepped, mu - h * tangent(t), w);
    for (int k = 0; k < mu.size; ++k)
      EXPECT_NEAR(x[k].slope[t], (ahead[k] - behind[k]) / (2 * h), 1e-8) << Scheme::info.name << ' ' << k << ' ' << t;
  }
}

}  // namespace polhode::test
