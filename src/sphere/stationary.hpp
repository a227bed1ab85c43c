// SPDX-License-Identifier: Apache-2.0
// The stationary density of a diffusion on the sphere (sphere/expectations/expectation.hpp).
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "sphere/galerkin/reference_value.hpp"
#include "sphere/sphere_problem.hpp"

namespace polhode {

/// Density against the area of the unit sphere, in harmonics.
struct stationary_law {
  std::optional<Eigen::VectorXd> density{};
  Eigen::VectorXd change{};  ///< what the last degree added to it
  double uncertainty = 0;    ///< in L2, by three degrees: bounds the change of E[f] over |f|_2
  int degree = 0;
  std::string reason{};
};
/// wanted: the degree; 0 lets the program choose.
stationary_law stationary(const sphere_problem& problem, double tolerance, int wanted = 0);

/// E[f] under the law, uncertain by what the last degree changed.
reference_value mean(const sphere_problem& problem, const stationary_law& law, const sphere_function& f);

/// E[f] under every stationary law, to an absolute tolerance; nothing where laws differ in it. wanted: as
/// above.
reference_value stationary_mean(const sphere_problem& problem, const sphere_function& f, double tolerance,
                                int wanted = 0);

}  // namespace polhode
