// SPDX-License-Identifier: Apache-2.0
// The mean energy without dissipation: the free motion keeps h, so that noise alone moves it, dE[h]/dt = E[L h] with
// L h = 1/2 sum_ij Q_ij L_i L_j h, a quadratic function of Pi ("trace formula": for additive noise 1/2 tr of Hessian
// times covariance, Chen, Cohen, D'Ambrosio, Lang, Adv. Comput. Math. 46 (2020) 27; here orbits are compact, and
// nothing grows for ever). Isotropic noise, Q = sigma^2 one: L h = -3 sigma^2 (h - m), m the mean over the sphere,
// hence
//
//   E[h(Pi_t)] = m + (h(Pi_0) - m) exp(-3 sigma^2 t),   m = |Pi|^2 tr(I^-1) / 6,   for all t.
#pragma once

#include "sphere/harmonics/harmonics.hpp"
#include "sphere/sphere_problem.hpp"

namespace polhode {

/// |Pi|^2 tr(I^-1) / 6.
double mean_energy_over_sphere(const sphere_problem&);

/// E[h(Pi_time)] from every point (a row, of length radius), theta = 0, time >= 0. In closed form where the noise is
/// isotropic; else by exp(time L) on harmonics, uncertain by what four degrees more change.
struct mean_energies {
  Eigen::VectorXd value;
  double uncertainty;
};
mean_energies energy_without_dissipation(const sphere_problem&, const points_on_sphere& from, double time);

/// (L h)(Pi) at every point: the rate at which E[h] sets off.
Eigen::VectorXd energy_drift(const sphere_problem&, const points_on_sphere& at);

/// E[h] from a start of energy h after any time: isotropic noise of strength sigma^2.
double relaxed_energy(const sphere_problem&, double energy, double time);

}  // namespace polhode
