// What one step of a scheme costs on a scene: measured in this run on this machine, and counted.
#pragma once

#include "experiments/experiment.hpp"

namespace polhode {

struct step_cost {
  double ns = 0, low = 0,
         high = 0;     ///< CPU time a path and step, one thread: the median of several runs, and their range
  double normals = 0;  ///< drawn a path and step
};

/// Of independent paths through the pack kernels, their noise included (fast normals); takes some milliseconds.
step_cost cost_of_step(const context&, const scheme_entry&, double dt);

/// ns a normal of the scene's noise, drawn alone; 0 without noise.
double ns_per_normal(const context&);

}  // namespace polhode
