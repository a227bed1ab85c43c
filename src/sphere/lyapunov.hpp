// SPDX-License-Identifier: Apache-2.0
// Lyapunov exponents of a stochastic flow on the momentum sphere, without sampling.
//
// A tangent direction at x = Pi / c is a frame R = (v, w, x), w = x cross v. With A = c quadratic, b = field,
// t = damping c, a = Ax + b + t x cross (Ax + b),
//
//   dR = -(a dt + sum sigma_i o dW_i)^ R + omega R e_3^ dt,   omega = v.Av - t w.Av,   d log|dx| = s dt,
//   s = -w.Av + t (x.Ax + b.x - v.Av),   lambda_1 = E_nu[s]   (Furstenberg-Khasminskii),
//
// nu the stationary law on SO(3), solved for in Wigner functions. The noise turns the sphere rigidly, so the sum of
// both exponents is the mean divergence of the drift -t grad(x.Ax / 2 + b.x) on the sphere, for every constant noise:
//
//   lambda_1 + lambda_2 = -t E[tr A - 3 x.Ax - 2 b.x] = -damping E[c^2 tr quadratic - 3 Pi.quadratic Pi - 2 field.Pi],
//
// E under the stationary law of Pi.
#pragma once

#include "sphere/sphere_problem.hpp"

namespace polhode {

struct lyapunov_exponents {
  std::optional<double> lambda1{};
  double uncertainty = 0;  ///< of lambda1: proved (sphere/galerkin/poisson.hpp), or what three degrees say
  double sum = 0;          ///< lambda1 + lambda2
  double sum_uncertainty = 0;
  double dimension = 0;  ///< of the random attractor, see kaplan_yorke
  int degree = 0;        ///< of the Wigner functions
  std::string reason{};  ///< empty if converged to the tolerance; else one sentence
};

/// Kaplan-Yorke dimension 1 + lambda1 / |lambda2|; 0 (a point) for lambda1 <= 0, 2 (the sphere) where area is
/// conserved.
double kaplan_yorke(double lambda1, double sum);

/// To an absolute tolerance in both lambda1 and the sum. Without noise, under noise that depends on the state, or
/// where the law is not unique: no value. wanted: the degree; 0 lets the program choose.
lyapunov_exponents lyapunov(const sphere_problem& problem, double tolerance, int wanted = 0);

}  // namespace polhode
