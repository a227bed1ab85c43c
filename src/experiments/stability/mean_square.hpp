// SPDX-License-Identifier: Apache-2.0
// Do mean squares beside an equilibrium grow or shrink as those of the equation do?
//
// Where h is stationary the equation without noise stands still, and so does that with noise along the direction alone
// (sphere/closed_forms/linearised.hpp). One step of a scheme has the Jacobian J there, by dual numbers, and E[J x
// J], by Gauss-Hermite nodes of the noise, takes mean squares one step on: log of its spectral radius over dt is the
// scheme's own rate of growth. Nothing is sampled. As mean squares are expectations its error falls at the weak order
// for one noise vector.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "problem/subject.hpp"
#include "sphere/sphere_problem.hpp"

namespace polhode {

/// An equilibrium that some noise acts along.
struct noisy_equilibrium {
  std::string name;  ///< "axis 1": in the order of the axes; in a field "equilibrium 1": in order of energy
  Eigen::Vector3d direction;
  double strength;  ///< of the noise along it
};
std::vector<noisy_equilibrium> noisy_equilibria(const subject&);

/// The scene with the momentum there and, of the noise, what acts along it.
report::scene beside(const report::scene&, const noisy_equilibrium&);

/// Rate of growth of mean squares under steps of dt of the scheme, on a scene beside the equilibrium.
double own_mean_square_growth(const subject& beside, const scheme_entry&, const Eigen::Vector3d& direction, double dt);

/// The same of the equation.
double true_mean_square_growth(const sphere_problem&, const noisy_equilibrium&);

}  // namespace polhode
