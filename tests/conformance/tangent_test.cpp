// SPDX-License-Identifier: Apache-2.0
// Tangent kernels: the states are those of the scheme's ordinary kernel, and the tangents are its derivative, by
// differences of that kernel, which knows nothing of dual numbers.
#include <gtest/gtest.h>

#include "platform/isa.hpp"
#include "run/verify.hpp"
#include "support/kernel_cases.hpp"
#include "support/schemes.hpp"
#include "systems/bind.hpp"

namespace polhode::test {
namespace {

using numbers = std::vector<double>;

/// Two vectors at the momentum, tangent to its orbit: ad*_xi mu, the first by a turn, the second by another.
numbers tangents_at(std::span<const double> mu) {
  numbers out;
  for (int t = 0; t < tangent_vectors; ++t)
    for (std::size_t k = 0; k < mu.size(); ++k) {
      const std::size_t factor = k / 3 * 3, j = factor + (k + 1) % 3, l = factor + (k + 2) % 3;
      const double xi_l = t == 0 ? 1.0 : 0.5 - 0.3 * static_cast<double>(l % 3),
                   xi_j = t == 0 ? 1.0 : 0.5 - 0.3 * static_cast<double>(j % 3);
      out.insert(out.end(), block_lanes, mu[j] * xi_l - mu[l] * xi_j);
    }
  return out;
}

numbers moved(const kernel& k, numbers states, std::span<const double> tangent, double by, const increment_view& w) {
  for (std::size_t i = 0; i < states.size(); ++i) states[i] += by * tangent[i];
  k.advance(states, w);
  return states;
}

void expect_derivative(const subject& s, int steps, double dt, const std::string& where) {
  const auto& entry = s.schemes.front();
  const increments w(*s.model, steps, dt);
  const auto ordinary = entry.make(dt);
  const auto start = replicated(s.scene.momentum);
  const auto before = tangents_at(s.scene.momentum);
  auto states = start, plain = start, after = before;
  entry.tangent(dt)->advance(states, after, w.view);
  ordinary->advance(plain, w.view);
  constexpr double h = 1e-5;
  for (std::size_t i = 0; i < states.size(); ++i) {
    ASSERT_NEAR(states[i], plain[i], 1e-12) << where;
    ASSERT_TRUE(std::isfinite(after[i])) << where;
  }
  for (std::size_t t = 0; t < tangent_vectors; ++t) {
    const auto tangent = std::span(before).subspan(t * start.size(), start.size());
    const auto ahead = moved(*ordinary, start, tangent, h, w.view),
               behind = moved(*ordinary, start, tangent, -h, w.view);
    for (std::size_t i = 0; i < start.size(); ++i)
      ASSERT_NEAR(after[t * start.size() + i], (ahead[i] - behind[i]) / (2 * h), 1e-8) << where << ", vector " << t;
  }
}

template <class Scheme>
struct Tangents : testing::Test {
  void TearDown() override { choose_isa(usable_isas().back()); }
};
TYPED_TEST_SUITE(Tangents, every_scheme);

subject only(subject s, std::string_view scheme) {
  std::erase_if(s.schemes, [&](const scheme_entry& e) { return e.info.name != scheme; });
  return s;
}

TYPED_TEST(Tangents, IsTheDerivativeOfTheOrdinaryKernel) {
  for (const isa level : usable_isas()) {
    choose_isa(level);
    for (const auto& scene : every_part()) {
      const auto name = std::string(TypeParam::info.name) + " on " + std::string(name_of(level)) + ", inertia " +
                        std::to_string(scene.vector("inertia")[1]) + ", theta " + std::to_string(scene.number("theta"));
      const auto s = only(bind_scene(scene), TypeParam::info.name);
      expect_derivative(s, 200, 0.01, name);
      expect_derivative(s, 6, 0.3, name);
    }
  }
}

// One scheme of products alone, one of exponentials; every scheme's step with dual numbers: scheme_test.cpp. One step,
// as the kernel of many merges flows, which are exact on so(3) but not on this so(4).
TEST(Tangent, IsTheDerivativeOnAnyAlgebra) {
  auto scene = load_scene("paper");
  scene.momentum = {0.6, 0.48, 0.64, -0.3, 0.8, 0.5};
  const auto make = [](const report::scene&) { return coupled_bodies(); };
  const auto s = bind(scene, make, scheme_list<milstein, magnus>{});
  ASSERT_EQ(s.schemes.size(), 2u);
  for (const auto& e : s.schemes) expect_derivative(only(s, e.info.name), 1, 0.1, std::string(e.info.name));
}

}  // namespace
}  // namespace polhode::test
