// SPDX-License-Identifier: Apache-2.0
// The fluid on the torus: Zeitlin's sum over complex modes by Boost.Odeint, and Euler's equation itself.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <map>
#include <utility>
#include <vector>

#include <polhode/noise/normal.hpp>
#include <polhode/systems/sine_euler.hpp>

#include "references/odeint.hpp"

namespace polhode::test {
namespace {

using vorticity = sine_euler::state<double>;
using complex = std::complex<double>;
using modes = std::map<std::pair<int, int>, complex>;

sine_euler fluid(int n) { return {n, 0, sine_euler::isotropic(0, n * n - 1)}; }

vorticity some_state(int n) {
  const auto numbers = normals<24>({5, noise_kind::initial_state, 0, 0});
  vorticity mu(n * n - 1);
  for (int k = 0; k < mu.size; ++k) mu[k] = numbers[k];
  return mu;
}

modes modes_of(int n, std::span<const double> mu) {
  modes out;
  std::size_t place = 0;
  for (int k1 = 0; k1 <= n / 2; ++k1)
    for (int k2 = -(n / 2); k2 <= n / 2; ++k2)
      if (k1 > 0 || k2 > 0) {
        out[{k1, k2}] = complex(mu[place], mu[place + 1]) / std::sqrt(2.0);
        out[{-k1, -k2}] = std::conj(out[{k1, k2}]);
        place += 2;
      }
  return out;
}

int reduced(int k, int n) { return (k + 2 * n + n / 2) % n - n / 2; }

/// w_m' = -n/2 pi sum_k sin(2 pi (k x m)/n) w_k w_{m-k} / |k|^2.
modes zeitlins_slope(int n, const modes& w) {
  modes out;
  for (const auto& [m, unused] : w) {
    complex sum = 0;
    for (const auto& [k, wk] : w) {
      const auto rest = w.find({reduced(m.first - k.first, n), reduced(m.second - k.second, n)});
      if (rest == w.end()) continue;
      const int cross = k.first * m.second - k.second * m.first, square = k.first * k.first + k.second * k.second;
      sum -= n / (2 * M_PI) * std::sin(2 * M_PI * cross / n) / square * wk * rest->second;
    }
    out[m] = sum;
  }
  return out;
}

void put(const modes& w, int n, std::span<double> out) {
  std::size_t place = 0;
  for (int k1 = 0; k1 <= n / 2; ++k1)
    for (int k2 = -(n / 2); k2 <= n / 2; ++k2)
      if (k1 > 0 || k2 > 0) {
        out[place++] = std::sqrt(2.0) * w.at({k1, k2}).real();
        out[place++] = std::sqrt(2.0) * w.at({k1, k2}).imag();
      }
}

template <class Drift>
vorticity solved_fluid(const Drift& drift, const vorticity& mu, double t) {
  const auto end = solve_drift(drift, std::vector<double>(mu.begin(), mu.end()), t);
  vorticity out(mu.size);
  std::ranges::copy(end, out.begin());
  return out;
}
vorticity fluid_after(const sine_euler& s, const vorticity& mu, double t) {
  return solved_fluid(
      [&](std::span<const double> x, std::span<double> out) {
        vorticity m(mu.size);
        std::ranges::copy(x, m.begin());
        std::ranges::copy(su::coad(s.omega(m), m), out.begin());
      },
      mu, t);
}

TEST(SineEuler, MovesAsZeitlinsModes) {
  for (const int n : {3, 5}) {
    const auto start = some_state(n);
    const auto truth = solved_fluid(
        [&](std::span<const double> x, std::span<double> out) { put(zeitlins_slope(n, modes_of(n, x)), n, out); },
        start, 2);
    const auto apart = fluid_after(fluid(n), start, 2) - truth, moved = truth - start;
    EXPECT_LE(std::sqrt(dot(apart, apart)), 1e-11) << n;
    EXPECT_GT(std::sqrt(dot(moved, moved)), 0.3) << n;
  }
}

// omega = mu / |k|^2, of as many components as mu.
TEST(SineEuler, HasTheInverseLaplacianOfEveryMode) {
  for (const int n : {3, 5}) {
    const auto f = fluid(n);
    ASSERT_EQ(f.inverse_square.size, n * n - 1);
    int place = 0;
    for (int k1 = 0; k1 <= n / 2; ++k1)
      for (int k2 = -(n / 2); k2 <= n / 2; ++k2) {
        if (k1 == 0 && k2 <= 0) continue;
        for (int part = 0; part < 2; ++part) EXPECT_EQ(f.inverse_square[place++], 1.0 / (k1 * k1 + k2 * k2));
      }
  }
}

TEST(SineEuler, KeepsEnergyAndCasimirs) {
  for (const int n : {3, 5}) {
    const auto s = fluid(n);
    const auto start = some_state(n), end = fluid_after(s, start, 2);
    double energy = 0;
    for (const auto& [k, w] : modes_of(n, {start.begin(), start.end()}))
      energy += 0.5 * std::norm(w) / (k.first * k.first + k.second * k.second);
    EXPECT_NEAR(s.energy(start), energy, 1e-15);
    EXPECT_NEAR(s.energy(end), energy, 1e-12);
    for (int j = 0; j < n - 1; ++j) EXPECT_NEAR(su::casimirs(end)[j], su::casimirs(start)[j], 1e-11) << n << ' ' << j;
  }
}

/// By the exponential of its matrix: the part of h on the line of k = (1, 0), and on that of (0, 1).
TEST(SineEuler, LinesTurnByOneElementOfTheAlgebra) {
  for (const int n : {3, 5}) {
    const auto s = fluid(n);
    const auto start = some_state(n);
    auto first = 0.7 * s.omega(start), last = first;
    su::for_each_mode(n, [&](int place, int k1, int k2) {
      for (const int part : {place, place + 1}) {
        if (k2 != 0) first[part] = 0;
        if (k1 != 0) last[part] = 0;
      }
    });
    const auto apart = s.first_turn(start, 0.7) - su::exp_action(first, start);
    EXPECT_LE(std::sqrt(dot(apart, apart)), 1e-14) << n;
    const auto other = s.line_turn(start, n, 0.7) - su::exp_action(last, start);
    EXPECT_LE(std::sqrt(dot(other, other)), 1e-14) << n;
  }
}

/// Mode m of -u.grad w on a grid, u = (-psi_y, psi_x), of w = 2 Re(a exp(i k.x) + b exp(i l.x)).
complex eulers_slope(std::pair<int, int> k, complex a, std::pair<int, int> l, complex b, std::pair<int, int> m) {
  constexpr int grid = 16;
  const complex i(0, 1);
  complex sum = 0;
  for (int p = 0; p < grid * grid; ++p) {
    const int column = p % grid, row = p / grid;
    const double x = 2 * M_PI * column / grid, y = 2 * M_PI * row / grid;
    double w_x = 0, w_y = 0, psi_x = 0, psi_y = 0;
    for (const auto& [mode, size] : {std::pair{k, a}, std::pair{l, b}}) {
      const auto [p1, p2] = mode;
      const complex wave = 2.0 * size * std::exp(i * (p1 * x + p2 * y));
      w_x += (i * double(p1) * wave).real();
      w_y += (i * double(p2) * wave).real();
      psi_x -= (i * double(p1) * wave).real() / (p1 * p1 + p2 * p2);
      psi_y -= (i * double(p2) * wave).real() / (p1 * p1 + p2 * p2);
    }
    sum -= (-psi_y * w_x + psi_x * w_y) * std::exp(-i * (m.first * x + m.second * y));
  }
  return sum / double(grid * grid);
}

/// But for the factor sin(x)/x, x = 2 pi (k x l)/n, that the truncation brings.
TEST(SineEuler, IsEulersEquationForLongWaves) {
  constexpr int n = 5;
  const std::pair k{1, 0}, l{1, 1}, m{2, 1};
  const complex a(0.3, -0.2), b(-0.1, 0.7);
  modes w;
  for (int k1 = -2; k1 <= 2; ++k1)
    for (int k2 = -2; k2 <= 2; ++k2)
      if (k1 != 0 || k2 != 0) w[{k1, k2}] = 0;
  w[k] = a, w[{-1, 0}] = std::conj(a), w[l] = b, w[{-1, -1}] = std::conj(b);
  vorticity mu(24), slope(24);
  put(w, n, {mu.begin(), mu.end()});
  slope = su::coad(fluid(n).omega(mu), mu);
  const double x = 2 * M_PI / n;
  const auto found = modes_of(n, {slope.begin(), slope.end()}).at(m);
  EXPECT_LE(std::abs(found - std::sin(x) / x * eulers_slope(k, a, l, b, m)), 1e-15);
  EXPECT_GT(std::abs(found), 0.05);
}

}  // namespace
}  // namespace polhode::test
