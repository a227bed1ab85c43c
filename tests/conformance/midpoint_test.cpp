// SPDX-License-Identifier: Apache-2.0
// The equation of a midpoint rule is solved for increments far beyond the usual ones too.
#include <gtest/gtest.h>

#include <polhode/noise/normal.hpp>
#include <polhode/schemes/implicit_midpoint.hpp>
#include <polhode/schemes/isospectral_midpoint.hpp>
#include <polhode/systems/spin.hpp>

namespace polhode::test {
namespace {

using spin_state = vec<double, 3>;

spin_state of_length(double length, std::uint64_t i, std::uint64_t draw) {
  const auto v = normals<3>({5, noise_kind::initial_state, i, draw});
  return (length / std::sqrt(dot(v, v))) * v;
}

/// By m' = mu + f(m)/2 - m over a long time: a turn beside what draws inwards, so that it comes to rest.
template <class Rule>
spin_state solved(const spin& s, const spin_state& mu, const wiener<double, 3>& w) {
  auto m = mu;
  for (int i = 0; i < 2000; ++i) m = m + 0.1 * (mu + 0.5 * Rule::motion(s, m, w) - m);
  return so3::cayley_action(generator(s, m, w), mu);
}

template <class Rule>
void expect_solved() {
  constexpr double dt = 0.25, strength = 0.6, farthest = 8;
  const Eigen::Matrix3d easy_axis = Eigen::Vector3d(0, 0, -1.6).asDiagonal();
  const spin s(easy_axis, {-0.3, 0, -0.2}, 0, spin::isotropic(strength));
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const auto mu = of_length(1, i, 0);
    const wiener<double, 3> w{dt, of_length(farthest * std::sqrt(dt) * static_cast<double>(i % 20) / 20, i, 1)};
    const auto next = Rule::step(s, mu, w), exact = solved<Rule>(s, mu, w);
    EXPECT_LE(std::sqrt(dot(next - exact, next - exact)), 1e-12) << i;
  }
}

TEST(Midpoint, OfASpinIsSolvedForFarIncrements) {
  expect_solved<implicit_midpoint>();
  expect_solved<isospectral_midpoint>();
}

}  // namespace
}  // namespace polhode::test
