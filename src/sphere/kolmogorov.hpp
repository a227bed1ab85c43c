// A diffusion on the momentum sphere as linear algebra: expectations, stationary law and spectral gap
// without sampling. With x = Pi / c, c the radius, in spherical harmonics up to a degree:
//
//   L = -sum_i M[a_i] L_i + 1/2 sum_jk Q_jk L_j L_k,   a = Omega + damping Pi x Omega,   Q = covariance,
//   E[f(Pi_T)] = (exp(T L) f)(Pi_0),   L^T rho = 0,   gap = least |Re lambda| besides the constant's 0.
//
// L_i = (x cross grad)_i. A Galerkin projection of degree L leaves a remainder in degrees L + 1 and L + 2, known
// exactly. The semigroup is a contraction in the supremum norm, so the remainder proves a bar for expectations and
// stationary means (sphere/galerkin/poisson.hpp). Density and gap: three successive degrees agree, the last of them
// high enough for the width of the noise (sphere/galerkin/raise_degree.hpp).
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "sphere/backward_operator.hpp"
#include "sphere/galerkin/reference_value.hpp"
#include "sphere/harmonics.hpp"
#include "sphere/sphere_problem.hpp"

namespace polhode {

// degree: 0 lets the program choose; any other is taken as it is, with two lower ones where they tell the uncertainty.

/// E[f(Pi_time)] from Pi_0 = start (of length radius), time >= 0, to an absolute tolerance. Without noise: f on the one
/// path there is.
reference_value expectation(const sphere_problem& problem, const sphere_function& f, const Eigen::Vector3d& start,
                            double time, double tolerance, int degree = 0);

/// E[f] under every stationary law, to an absolute tolerance; nothing where laws differ in it.
reference_value stationary_mean(const sphere_problem& problem, const sphere_function& f, double tolerance,
                                int degree = 0);

/// Density against the area of the unit sphere, in harmonics.
struct stationary_law {
  std::optional<Eigen::VectorXd> density{};
  Eigen::VectorXd change{};  ///< what the last degree added to it
  double uncertainty = 0;    ///< in L2, by three degrees: bounds the change of E[f] over |f|_2
  int degree = 0;
  std::string reason{};
};
stationary_law stationary(const sphere_problem& problem, double tolerance, int degree = 0);

/// E[f] under the law, uncertain by what the last degree changed.
reference_value mean(const sphere_problem& problem, const stationary_law& law, const sphere_function& f);

/// Whether Pi along some axis, and functions of it, never change: one constant noise vector along an axis of revolution
/// of h without dissipation, or any one vector where h is constant. No other smooth function is conserved.
bool conserves_a_component(const sphere_problem& problem);

/// Whether the uniform law is stationary: no dissipation, and a noise that turns the sphere rigidly.
bool has_uniform_law(const sphere_problem& problem);

/// Why there is more than one stationary law; empty where no reason is known. One noise vector on an axis that is an
/// equilibrium leaves the state at rest there, so that a point mass is stationary too.
std::string no_unique_law(const sphere_problem& problem);

/// The slowest rate at which expectations relax, to an absolute tolerance and to a hundredth of itself. 0 where a
/// further function is conserved (then no law is unique).
reference_value spectral_gap(const sphere_problem& problem, double tolerance, int degree = 0);

}  // namespace polhode
