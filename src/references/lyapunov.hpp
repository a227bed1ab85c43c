// Lyapunov exponents of the rigid body's stochastic flow on the momentum sphere, without sampling.
//
// A tangent direction at x is a frame R = (v, w, x), w = x cross v. With A = c I^-1, t = theta c, a = Ax + t x cross
// Ax,
//
//   dR = -(a dt + sum sigma_i o dW_i)^ R + omega R e_3^ dt,   omega = v.Av - t w.Av,   d log|dx| = s dt,
//   s = -w.Av + t (x.Ax - v.Av),   lambda_1 = E_nu[s]   (Furstenberg-Khasminskii),
//
// nu the stationary law on SO(3), solved for in Wigner functions. The noise turns the sphere rigidly, so the sum of
// both exponents is the mean divergence of the drift -t grad(x.Ax / 2) on the sphere, for every noise:
//
//   lambda_1 + lambda_2 = -t E[tr A - 3 x.Ax] = -theta (c^2 tr I^-1 - 6 E[h]),   E under the stationary law of Pi.
#pragma once

#include "references/kolmogorov.hpp"

namespace polhode {

struct lyapunov_exponents {
  std::optional<double> lambda1{};
  double uncertainty = 0;  ///< of lambda1: proved (references/poisson.hpp), or what three degrees say
  double sum = 0;          ///< lambda1 + lambda2
  double sum_uncertainty = 0;
  double dimension = 0;  ///< of the random attractor, see kaplan_yorke
  int degree = 0;        ///< of the Wigner functions
  std::string reason{};  ///< empty if converged to the tolerance; else one sentence
};

/// Kaplan-Yorke dimension 1 + lambda1 / |lambda2|; 0 (a point) for lambda1 <= 0, 2 (the sphere) where area is
/// conserved.
double kaplan_yorke(double lambda1, double sum);

/// To an absolute tolerance in both lambda1 and the sum. Without noise, or where the law is not unique: no value.
lyapunov_exponents lyapunov(const sphere_problem& problem, double tolerance, int degree = 0);

}  // namespace polhode
