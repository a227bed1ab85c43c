// SPDX-License-Identifier: Apache-2.0
// Which parameters the recorded transitions obey.
//
// The moment equations sum Y(p) = 0 of the transition test, one a test, solved for the parameters p by Gauss and
// Newton's method with the inverse of their covariance as weight (Hansen, Econometrica 50 (1982) 1029-1054); intervals
// from what was observed of Y, so that they do not rest on the scene's own noise.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "problem/subject.hpp"
#include "recorded/transition_moments.hpp"
#include "recorded/transition_test.hpp"
#include "statistics/sample.hpp"

namespace polhode {

/// A number of the equation, and how a scene is given another in its place.
struct fitted_parameter {
  std::string name;
  double in_scene = 0;
  double unit = 1;  ///< a change of it that matters
  std::function<void(report::scene&, double)> set = {};
};
/// The strength of all noise, that of the dissipation, and every number of the energy. Noise of several strengths: as a
/// multiple of the scene's.
std::vector<fitted_parameter> parameters_to_fit(const subject&);

/// Transitions of one interval on one sphere.
struct transition_class {
  double radius, dt;
  transition_moments moments;
};

struct followed_parameter {
  std::string name;
  double in_scene = 0;
  interval_estimate value = {};  ///< 95 %
  bool held = false;             ///< what it does, those before it do: taken from the scene
};
struct followed_equation {
  std::vector<followed_parameter> parameters = {};
  std::string reason = {};  ///< why there is none; empty: there is
};

/// variance: of all tests, summed over the classes.
followed_equation equation_followed(const subject&, std::vector<transition_class>&, const Eigen::MatrixXd& variance,
                                    const test_family&);

/// The scene's equation on the sphere of another radius.
sphere_problem on_radius(const report::scene&, double radius);

}  // namespace polhode
