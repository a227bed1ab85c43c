// SPDX-License-Identifier: Apache-2.0
// Point vortices: the published equation by Boost.Odeint, and relative equilibria whose rates are known.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include <polhode/simd.hpp>
#include <polhode/systems/vortices.hpp>

#include "references/odeint.hpp"

namespace polhode::test {
namespace {

using vortex_state = spins::state<double>;
using position = Eigen::Vector3d;
using positions = std::vector<position>;

constexpr double around = 4 * M_PI;

spins free_vortices(const std::vector<double>& strengths) {
  return vortices(strengths, 0, spins::isotropic(0, static_cast<int>(3 * strengths.size())));
}
vortex_state vortices_at(const positions& x, const std::vector<double>& strengths) {
  vortex_state mu(static_cast<int>(3 * x.size()));
  for (int i = 0; i < mu.size; ++i)
    mu[i] = -strengths[static_cast<std::size_t>(i / 3)] * x[static_cast<std::size_t>(i / 3)][i % 3];
  return mu;
}
position position_of(const vortex_state& mu, const std::vector<double>& strengths, int i) {
  return position(mu[3 * i], mu[3 * i + 1], mu[3 * i + 2]) / -strengths[static_cast<std::size_t>(i)];
}

/// x_i' = 1/(4 pi) sum_j Gamma_j x_j x x_i / (1 - x_i.x_j) (Newton 2001, ch. 4).
positions by_published_equation(const positions& x, const std::vector<double>& strengths, double t) {
  std::vector<double> flat;
  for (const auto& one : x) flat.insert(flat.end(), one.begin(), one.end());
  const auto end = solve_drift(
      [&](std::span<const double> now, std::span<double> out) {
        for (std::size_t i = 0; i < x.size(); ++i) {
          const position own(now.data() + 3 * i);
          position velocity = position::Zero();
          for (std::size_t j = 0; j < x.size(); ++j) {
            const position other(now.data() + 3 * j);
            if (j != i) velocity += strengths[j] / around * other.cross(own) / (1 - own.dot(other));
          }
          std::ranges::copy(velocity, out.begin() + static_cast<std::ptrdiff_t>(3 * i));
        }
      },
      flat, t);
  positions out;
  for (std::size_t i = 0; i < x.size(); ++i) out.emplace_back(end.data() + 3 * i);
  return out;
}
/// dmu = ad*_{dh/dmu} mu.
vortex_state vortices_after(const spins& s, const vortex_state& mu, double t) {
  const auto end = solve_drift(
      [&](std::span<const double> x, std::span<double> out) {
        vortex_state m(mu.size);
        std::ranges::copy(x, m.begin());
        std::ranges::copy(spins::group::coad(s.omega(m), m), out.begin());
      },
      std::vector<double>(mu.begin(), mu.end()), t);
  vortex_state out(mu.size);
  std::ranges::copy(end, out.begin());
  return out;
}

const std::vector<double> mixed{2, 1.5, -1, 2.5};
const positions four{{0.6, 0, 0.8}, {0, -0.8, 0.6}, {-0.48, 0.6, -0.64}, {0.64, 0.48, -0.6}};

TEST(Vortices, MoveByThePublishedEquation) {
  const auto s = free_vortices(mixed);
  const auto end = vortices_after(s, vortices_at(four, mixed), 4);
  const auto truth = by_published_equation(four, mixed, 4);
  for (int i = 0; i < 4; ++i) {
    EXPECT_LE((position_of(end, mixed, i) - truth[static_cast<std::size_t>(i)]).norm(), 1e-11) << i;
    EXPECT_GT((truth[static_cast<std::size_t>(i)] - four[static_cast<std::size_t>(i)]).norm(), 0.3) << i;
  }
}

TEST(Vortices, KeepTheirEnergyAndTheSumOfTheirMomenta) {
  const auto s = free_vortices(mixed);
  double expected = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      expected -= mixed[i] * mixed[j] / around * std::log(1 - four[i].dot(four[j]));
  const auto start = vortices_at(four, mixed), end = vortices_after(s, start, 4);
  EXPECT_NEAR(s.energy(start), expected, 1e-15);
  EXPECT_NEAR(s.energy(end), expected, 1e-12);
  for (int k = 0; k < 3; ++k) {
    double before = 0, after = 0;
    for (int i = 0; i < 4; ++i) before += start[3 * i + k], after += end[3 * i + k];
    EXPECT_NEAR(after, before, 1e-12) << k;
  }
}

/// Both turn about Gamma_1 x_1 + Gamma_2 x_2, at its length over 4 pi (1 - x_1.x_2): the flow of the splitting is
/// exact.
TEST(Vortices, TwoOfThemTurnAboutTheirCentre) {
  const positions two{four[0], four[3]};
  for (const double other : {1.5, -1.5, -2.0}) {
    const std::vector<double> strengths{2, other};
    const auto s = free_vortices(strengths);
    const position centre = 2 * two[0] + other * two[1];
    for (const double t : {0.3, 5.0}) {
      const Eigen::AngleAxisd turn(t * centre.norm() / (around * (1 - two[0].dot(two[1]))), centre.normalized());
      const auto end = s.free_flow(vortices_at(two, strengths), t);
      for (int i = 0; i < 2; ++i)
        EXPECT_LE((position_of(end, strengths, i) - turn * two[static_cast<std::size_t>(i)]).norm(), 1e-14) << other;
    }
  }
}

/// A ring of N at colatitude b turns at the rate Gamma (N - 1) cos b / (4 pi sin^2 b) (Polvani, Dritschel 1993).
TEST(Vortices, RingsTurnAtTheirRate) {
  constexpr double colatitude = 0.7, strength = 1.3, t = 2;
  for (const int n : {3, 5}) {
    positions ring;
    for (int i = 0; i < n; ++i) {
      const double east = 2 * M_PI * i / n;
      ring.emplace_back(std::sin(colatitude) * std::cos(east), std::sin(colatitude) * std::sin(east),
                        std::cos(colatitude));
    }
    const std::vector<double> strengths(static_cast<std::size_t>(n), strength);
    const double rate = strength * (n - 1) * std::cos(colatitude) / (around * std::pow(std::sin(colatitude), 2));
    const auto end = vortices_after(free_vortices(strengths), vortices_at(ring, strengths), t);
    const Eigen::AngleAxisd turn(rate * t, position::UnitZ());
    for (int i = 0; i < n; ++i)
      EXPECT_LE((position_of(end, strengths, i) - turn * ring[static_cast<std::size_t>(i)]).norm(), 1e-12) << n;
  }
}

/// Where two meet nothing is finite, in their own lane alone.
TEST(Vortices, ThatMeetHaveNoFiniteStateNorEnergy) {
  const auto s = free_vortices({1, 1});
  vec<pack, spins::group::dimension> mu(6);
  for (int k = 0; k < 6; ++k) mu[k] = pack(0.0);
  mu[2] = pack(-1.0);
  mu[5] = pack([](auto lane) { return lane == 0 ? -1.0 : 0.0; });
  mu[3] = pack([](auto lane) { return lane == 0 ? 0.0 : -1.0; });
  const auto energy = s.energy(mu);
  const auto next = s.free_flow(mu, 0.1);
  EXPECT_FALSE(std::isfinite(static_cast<double>(energy[0])));
  EXPECT_FALSE(std::isfinite(static_cast<double>(next[0][0])));
  for (std::size_t lane = 1; lane < pack::size(); ++lane) {
    EXPECT_EQ(static_cast<double>(energy[lane]), 0) << lane;
    EXPECT_TRUE(std::isfinite(static_cast<double>(next[0][lane]))) << lane;
  }
}

}  // namespace
}  // namespace polhode::test
