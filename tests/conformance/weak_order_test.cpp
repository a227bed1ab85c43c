// SPDX-License-Identifier: Apache-2.0
// The mean of one step against the mean of the solution, neither sampled: they differ by one order more in dt than the
// weak order that the scheme claims, neither less nor more, under any noise, isotropic noise and one vector.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "support/mean_over_increments.hpp"
#include "support/schemes.hpp"

namespace polhode::test {
namespace {

/// In N variables, as a scalar: what a system computes of a state it computes of the coordinates themselves.
template <int N>
class polynomial {
 public:
  polynomial() = default;
  explicit polynomial(double constant) { terms_[{}] = constant; }
  static polynomial coordinate(int i) {
    polynomial x;
    std::array<int, N> powers{};
    powers[std::size_t(i)] = 1;
    x.terms_[powers] = 1;
    return x;
  }

  double operator()(const vec<double, N>& x) const {
    double sum = 0;
    for (const auto& [powers, c] : terms_) {
      double term = c;
      for (int i = 0; i < N; ++i) term *= std::pow(x[i], powers[std::size_t(i)]);
      sum += term;
    }
    return sum;
  }
  polynomial derivative(int i) const {
    polynomial out;
    for (const auto& [powers, c] : terms_) {
      auto lowered = powers;
      if (const int n = lowered[std::size_t(i)]--; n > 0) out.terms_[lowered] = n * c;
    }
    return out;
  }

  friend polynomial operator+(polynomial a, const polynomial& b) {
    for (const auto& [powers, c] : b.terms_) a.terms_[powers] += c;
    return a;
  }
  friend polynomial operator-(const polynomial& a) { return polynomial(-1.0) * a; }
  friend polynomial operator-(const polynomial& a, const polynomial& b) { return a + -b; }
  friend polynomial operator*(const polynomial& a, const polynomial& b) {
    polynomial out;
    for (const auto& [p, left] : a.terms_)
      for (const auto& [q, right] : b.terms_) {
        auto powers = p;
        for (std::size_t i = 0; i < N; ++i) powers[i] += q[i];
        out.terms_[powers] += left * right;
      }
    return out;
  }
  friend polynomial operator*(double a, const polynomial& b) { return polynomial(a) * b; }

 private:
  std::map<std::array<int, N>, double> terms_;
};

/// A_0 f + 1/2 sum_i A_i A_i f, A_0 along ad*_a(mu) mu and A_i along ad*_sigma_i mu: the generator of the Stratonovich
/// equation.
template <class System, int N = System::dimension>
polynomial<N> generated(const System& system, const polynomial<N>& f) {
  vec<polynomial<N>, N> mu;
  for (int i = 0; i < N; ++i) mu[i] = polynomial<N>::coordinate(i);
  const auto along = [](const vec<polynomial<N>, N>& field, const polynomial<N>& g) {
    polynomial<N> sum;
    for (int i = 0; i < N; ++i) sum = sum + field[i] * g.derivative(i);
    return sum;
  };
  auto sum = along(System::algebra::coad(system.generator(mu), mu), f);
  for (int channel = 0; channel < System::channels; ++channel) {
    vec<polynomial<N>, N> sigma;
    for (int i = 0; i < N; ++i) sigma[i] = polynomial<N>(system.sigma()(i, channel));
    const auto field = System::algebra::coad(sigma, mu);
    sum = sum + 0.5 * along(field, along(field, f));
  }
  return sum;
}

/// E f(mu_dt), to dt^4 / 24 L^4 f: f(mu) + dt L f + dt^2 / 2 L^2 f + dt^3 / 6 L^3 f.
template <class System, int N = System::dimension>
auto true_mean(const System& system, polynomial<N> f, const vec<double, N>& mu) {
  std::array<double, 4> terms{};
  for (int k = 0; k < 4; ++k) {
    terms[std::size_t(k)] = f(mu);
    if (k < 3) f = (1.0 / (k + 1)) * generated(system, f);
  }
  return [terms](double dt) { return terms[0] + dt * (terms[1] + dt * (terms[2] + dt * terms[3])); };
}

/// Of the areas a weak order of one asks no more than that their mean is zero: they are.
template <class Scheme, class System, class F>
double mean_of_a_step(const System& system, const state_of<System>& mu, double dt, const F& f) {
  const auto stepped = prepared<Scheme>(system, dt);
  std::vector<int> acting;
  for (int i = 0; i < System::channels; ++i)
    if (!stepped.sigma().col(i).isZero(0.0)) acting.push_back(i);
  return mean_over_increments<System::channels>(dt, acting,
                                                [&](const auto& w) { return f(Scheme::step(stepped, mu, w)); });
}

/// Of the coordinates and of a quadratic function of them all, as for one of them dt's first power may vanish.
template <class Scheme, class System, int N = System::dimension>
void expect_local_weak_order(const System& system, const state_of<System>& mu, double weak_order) {
  std::vector<polynomial<N>> functions(1);
  for (int i = 0; i < N; ++i) {
    functions.push_back(polynomial<N>::coordinate(i));
    functions[0] = functions[0] + (0.3 + 0.2 * i) * functions.back() * polynomial<N>::coordinate((i + 1) % N);
  }
  double coarse = 0, fine = 0;
  for (const auto& f : functions) {
    const auto exact = true_mean(system, f, mu);
    const auto error = [&](double dt) { return mean_of_a_step<Scheme>(system, mu, dt, f) - exact(dt); };
    coarse = std::hypot(coarse, error(0x1p-8));
    fine = std::hypot(fine, error(0x1p-10));
  }
  EXPECT_NEAR(std::log2(coarse / fine) / 2, weak_order + 1, 0.05) << Scheme::info.name;
}

const vec<double, 6> pair_momentum{{0.6, 0.48, 0.64, -0.3, 0.8, 0.5}};

template <class Scheme>
struct LocalWeakError : testing::Test {};
TYPED_TEST_SUITE(LocalWeakError, every_scheme);

TYPED_TEST(LocalWeakError, FallsAsTheWeakOrderSaysUnderAnyNoise) {
  const vec<double, 3> sigma[] = {{{0.5, 0.1, 0}}, {{0, 0.4, 0.2}}, {{0.3, 0, 0.6}}};
  const rigid_body body({1, 2, 3}, 0.5, rigid_body::from_vectors(sigma));
  expect_local_weak_order<TypeParam>(body, paper_momentum, TypeParam::info.weak_order.general);
  so4_body::matrix vectors = 0.5 * so4_body::matrix::Identity();
  vectors(0, 1) = 0.3, vectors(4, 2) = -0.2, vectors(3, 5) = 0.4;
  expect_local_weak_order<TypeParam>(coupled_bodies(0.4, vectors), pair_momentum, TypeParam::info.weak_order.general);
}

TYPED_TEST(LocalWeakError, FallsAsTheWeakOrderSaysUnderIsotropicNoise) {
  expect_local_weak_order<TypeParam>(paper_body(), paper_momentum, TypeParam::info.weak_order.isotropic);
  expect_local_weak_order<TypeParam>(coupled_bodies(), pair_momentum, TypeParam::info.weak_order.isotropic);
}

TYPED_TEST(LocalWeakError, FallsAsTheWeakOrderSaysUnderOneVector) {
  const vec<double, 3> sigma[] = {{{0.3, 0.4, 0.5}}};
  const rigid_body body({1, 2, 3}, 0.5, rigid_body::from_vectors(sigma));
  expect_local_weak_order<TypeParam>(body, paper_momentum, TypeParam::info.weak_order.one_vector);
  so4_body::matrix vector = so4_body::matrix::Zero();
  vector.col(0) << 0.3, 0.4, 0.5, -0.2, 0.6, 0.1;
  expect_local_weak_order<TypeParam>(coupled_bodies(0.4, vector), pair_momentum, TypeParam::info.weak_order.one_vector);
}

}  // namespace
}  // namespace polhode::test
