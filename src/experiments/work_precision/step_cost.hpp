// SPDX-License-Identifier: Apache-2.0
// What one step of a scheme costs on a scene: measured in this run on this machine, and counted.
//
// A machine is never quiet. So every measurement stands between two of a loop that never changes (yardstick.hpp), and
// is its ratio to them: what slows both drops out. It is repeated in slots that lie apart, all steps in turn, each with
// its states at another place of a page, and the yardstick's alike in every run; the cost is the median over the slots
// and its 96 % interval. ns are that ratio times the yardstick's own time, the median of the run. (Quickest times
// instead of medians of ratios: ten times the scatter on a busy machine.)
#pragma once

#include <array>
#include <vector>

#include "experiments/common/experiment.hpp"

namespace polhode {

struct step_cost {
  double ns = 0, low = 0, high = 0;  ///< CPU time a path and step, one thread, with its 96 % interval
  double normals = 0;                ///< drawn a path and step
};

/// The yardstick's own time a path and step, of one run of the program.
struct yardstick_time {
  double ns = 0, low = 0, high = 0;  ///< median, and the range of the middle half
};

/// One scheme at one dt, to be priced.
struct priced_step {
  const context* where;
  const scheme_entry* scheme;
  double dt;
};

/// Prices all of them, a slot of each in turn. Of independent paths through the pack kernels, their noise included
/// (fast normals); a slot takes below a millisecond.
std::vector<step_cost> costs_of_steps(const std::vector<priced_step>&, yardstick_time* = nullptr);

/// The same of one alone.
step_cost cost_of_step(const context&, const scheme_entry&, double dt);

/// ns a normal of the scene's noise, drawn alone; 0 without noise.
double ns_per_normal(const context&);

}  // namespace polhode
