// SPDX-License-Identifier: Apache-2.0
// What a system offers the experiments beyond its equation, on one scene. What it leaves empty they do without, and say
// so.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reports/model/scene.hpp"
#include "sphere/closed_forms/gibbs.hpp"
#include "sphere/galerkin/reference_value.hpp"
#include "sphere/products/sphere_pair.hpp"
#include "sphere/sphere_problem.hpp"

namespace polhode {

/// Per time, at the initial momentum: bounds on how fast each part of the equation turns it.
struct rate_bounds {
  double motion = 0;       ///< without dissipation and noise
  double dissipation = 0;  ///< all of it, at the scene's theta
  double damping = 0;      ///< of it per theta; 0: theta moves nothing
  double noise = 0;        ///< sum |sigma_i|^2
  double fastest() const { return motion + dissipation + noise; }
};

/// The motion without dissipation and noise, known in closed form.
struct free_motion {
  std::string method;
  std::function<std::vector<double>(double time)> at;
};

/// A shape of h that is moved to extremes: at(x) for x from least to greatest, in equal ratios; and one next to none.
struct shape_axis {
  std::string name;
  double least, greatest;
  std::function<report::scene(double)> at;
  std::string name_of_nearly_none;
  report::scene nearly_none;
};

/// A number of the state whose whole distribution under the Gibbs law is known.
struct known_marginal {
  std::string name;
  std::function<double(std::span<const double> mu)> value;
  std::function<double(double)> cdf;
};

struct capabilities {
  rate_bounds rates;
  std::string notice = {};  ///< what a user should know of a scene that is accepted
  /// The diffusion, where it lives on a sphere: all that is exact there follows.
  std::optional<sphere_problem> sphere = {};
  std::optional<sphere_pair> pair = {};  ///< where it lives on a product of two spheres: its expectations are exact
  std::optional<free_motion> free = {};
  std::optional<shape_axis> shape = {};
  std::function<report::scene(int power)> in_unit = {};  ///< the same solutions at |mu| times 4^power, t over it
  std::string in_cpp = {};                               ///< declares `body`, a system of the installed headers
  std::function<gibbs_law()> gibbs = {};                 ///< of an isotropically driven system, in closed form
  /// Of the Gibbs law, by the name of an observable; nothing for a name that it does not know.
  std::function<std::optional<reference_value>(std::string_view)> gibbs_mean = {};
  std::string no_gibbs_mean = {};            ///< why isotropic noise leaves no law here, or none in closed form
  std::vector<std::string> components = {};  ///< names of all of them; none: mu_1, mu_2, …
  std::string in_cpp_header = {};            ///< polhode/systems/….hpp of `body`; none: that of the system's name
  bool in_cpp_sized = false;                 ///< the size of its state is known when the program runs
  std::vector<known_marginal> gibbs_marginals = {};
};

}  // namespace polhode
