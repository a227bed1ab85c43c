// SPDX-License-Identifier: Apache-2.0
// Two results of one scene: what has changed beyond noise?
#pragma once

#include "reports/model/comparison.hpp"
#include "reports/model/results.hpp"

namespace polhode {

/// Claims: by verdict. Numbers, of the same experiment, scheme, quantity, observable, dt, number of steps and method:
///   sampled    changed if |after - before| > z sqrt(s^2 + s'^2), s = (width of the 95 % interval) / 3.92, z the
///              two-sided quantile at level 0.05 / N (Bonferroni): of all N sampled numbers together none is called
///              changed by chance in 95 of 100 comparisons of independent runs
///              one without an interval is of unknown noise: counted apart, never called changed
///   copies     (method: the name of an experiment) are judged where they were measured
///   others     changed if their intervals of uncertainty are apart by more than 1e-9 of the number
///   timings    on the same processor, instruction set, compiler and flags only, in units of the yardstick of their
///              run, a scheme's together (timings.hpp); never a regression
/// A number is an error, and its growth a regression, where its series is one to which an order is fitted.
/// Throws input_error where the two are not of the same scene.
report::comparison compare(const report::results& before, const report::results& after);

/// Throws input_error, naming the key, where two scenes differ in more than their names and steps.
void check_same_scene(const report::scene&, const report::scene&);

}  // namespace polhode
