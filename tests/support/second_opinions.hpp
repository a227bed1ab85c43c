// SPDX-License-Identifier: Apache-2.0
// What else can be said of an expectation, a stationary mean, a gap or an exponent: by methods of another kind where
// there is one, and by a projection on higher degrees. dear: also by those that take seconds.
#pragma once

#include <string>
#include <vector>

#include "sphere/expectations/expectation.hpp"
#include "support/attacked_scene.hpp"

namespace polhode::test {

struct second_opinion {
  double value, uncertainty;
  bool another_kind = true;
};
using opinions = std::vector<second_opinion>;

/// The largest |f| on the axes; of every observable there is, on the sphere.
double supremum_of(const sphere_problem&, const sphere_function& f);

opinions opinions_of_expectation(const attacked_scene&, const std::string& observable, int degree, bool dear);
opinions opinions_of_gap(const attacked_scene&, double found, int degree, bool dear);
opinions opinions_of_mean(const attacked_scene&, const sphere_function& f, int degree, bool dear);
opinions opinions_of_lambda1(const attacked_scene&, int degree);

/// On two grids, the coarser turned: an axis of the body is an equilibrium, and on a grid that holds it but resolves no
/// noise, Poisson's equation says f there, whatever the resolution.
void add_collocated_mean(opinions& all, const sphere_problem&, const sphere_function& f, double size);

}  // namespace polhode::test
