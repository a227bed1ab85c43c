// SPDX-License-Identifier: Apache-2.0
// Errors of the law in the measure of `select`: of schemes that keep the sphere, and of combinations of their averages.
#pragma once

#include "experiments/laws/law_errors.hpp"
#include "experiments/work_precision/known_errors.hpp"

namespace polhode {

/// Takes the place of a kind's rows of such schemes: these know the horizon alone, or other observables. At the rows'
/// steps, at twice the longest of them while that is not beyond `longest`, and at two thirds of a step where the error
/// hardly falls from it to its half (a hill between two steps is not to be overlooked). Combinations stand at the steps
/// of the scheme that they are made of.
void measure_on_the_sphere(const context&, const weak_law&, double longest, error_kind&);
void measure_on_the_sphere(const context&, const equilibrium_law&, double longest, error_kind&);

}  // namespace polhode
