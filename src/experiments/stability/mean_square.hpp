// Do mean squares beside an equilibrium grow or shrink as those of the equation do?
//
// The axes of the body are equilibria of the equation without noise, and of that with noise along the axis alone
// (sphere/closed_forms/linearised_body.hpp). One step of a scheme has the Jacobian J there, by dual numbers, and E[J x
// J], by Gauss-Hermite nodes of the noise, takes mean squares one step on: log of its spectral radius over dt is the
// scheme's own rate of growth. Nothing is sampled. As mean squares are expectations its error falls at the weak order
// for one noise vector.
#pragma once

#include <string_view>

#include "experiments/common/experiment.hpp"

namespace polhode {

/// The scene with the momentum on that axis (0 to 2) and, of the noise, what acts along the axis.
report::scene beside_axis(const report::scene&, int axis);

/// Rate of growth of mean squares under steps of dt of the scheme, on a scene beside the axis.
double own_mean_square_growth(const subject& beside, const scheme_entry&, int axis, double dt);

/// Of no scheme: the rates of the equation.
void report_true_growth(const subject&, report::results&);

/// Of one scheme: rates and their errors on each axis, the largest dt up to which equation and scheme agree on
/// stability, and the order of the errors. Nothing where no noise acts along any axis.
void report_mean_square(const context&, std::string_view scheme, report::results&);

}  // namespace polhode
