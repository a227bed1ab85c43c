// SPDX-License-Identifier: Apache-2.0
// A planted defect: a kind and its size. A scheme of the list with one thing wrong, on the kernels that ship.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "problem/subject.hpp"

namespace polhode::test {

/// What `size` means is said of each. dW, |dW|: in units of sqrt(dt), of the kernel's own view of the noise.
enum class kind {
  none,  ///< the healthy twin
  // The kernel of the scheme on a changed scene.
  noise,      ///< sigma × (1 + size)
  theta,      ///< theta × (1 + size)
  inertia_1,  ///< I_1 × (1 + size)
  inertia_2,
  inertia_3,
  channel_1,  ///< sigma_1 alone × (1 + size)
  // The kernel at a changed step.
  sub_flow,    ///< every flow but the noise over dt × (1 + size)
  horizon,     ///< all time × (1 + size), the noise with it
  step_count,  ///< `size` steps too many on the scene's horizon T, in law: all time × (1 + size dt/T)
  last_steps,  ///< of several steps at once the last `size` are not taken
  // The increments on their way into the kernel.
  dw,          ///< dW × (1 + size)
  area,        ///< areas × (1 + size); -2: sign flipped
  area_mixed,  ///< areas drawn anew, from the bits of dW
  channels,    ///< dW_2 = size dW_1 + sqrt(1 - size^2) dW_2; 1: the same
  lanes,       ///< the last `size` paths of a block take the noise of its first
  neighbours,  ///< every path of a block takes the noise of the one that is `size` places on
  steps,       ///< every second step takes the noise of the step before
  clip,        ///< |dW_i| at most size
  branch,      ///< no noise where |dW| > size
  // The state after a step.
  float_state,      ///< rounded to float
  float_projected,  ///< rounded to float, then back to its sphere
  turn,             ///< turned about e_3 by size dt, then back to its sphere
  shrink,           ///< × (1 - size dt)
  ito_drift,        ///< + size dt × the Ito drift: -1 misses a correction, 1 doubles it
  // Between the pieces of a run, and of a common noise.
  unfinished,  ///< a look at the states between two pieces is not finished
  reopened,    ///< every piece begins as if it were the first
  transposed,  ///< the matrices of the common noise
  // Inside the step (in_step.hpp).
  weights,       ///< of the stages 1/2 + size and 1/2 - size
  half_missing,  ///< the sum of the stages not halved
  stage,         ///< the second stage this far at the state of the first
  halves,        ///< of Strang (1 + size) dt/2 and (1 - size) dt/2
  exponential,   ///< cut after the second power
  flip,          ///< the state's sign changes where |sum sigma_i dW^i| > size of its mean strength
  // Of a kernel tuned to the rigid body (in_tuning.hpp).
  dissipation_sign,  ///< theta -> -theta, as the paper prints it
  half_turn,         ///< of Strang's last turn × (1 + size)
  half_shear,        ///< the same where it is a shear alone
  casimir_shift,     ///< by the axis `size`, turns about the axes 1 and 3
  damping_halved,    ///< a whole step damps by the factor of half a step
  normalisation,     ///< by a polynomial one degree short
  reach,             ///< rotations by the polynomials of a smaller size
  // The generator, for the whole run: schemes and references alike.
  generator_dw,        ///< increments × (1 + size)
  generator_channels,  ///< as channels
  generator_lanes,     ///< as lanes
  generator_steps,     ///< as steps
  generator_clip,      ///< as clip
  generator_paths,     ///< after `size` blocks the paths begin again
  generator_area,      ///< areas × (1 + size), drawn or coarsened
  // The claims alone.
  strong_claim,   ///< + size
  weak_claim,     ///< + size
  path_claim,     ///< deterministic order + size
  drift_claim,    ///< order of the Casimir drift + size
  casimir_claim,  ///< kept to rounding
  poisson_claim,  ///< a Poisson map
};

std::string_view name_of(kind);

struct defect {
  test::kind kind = kind::none;
  double size = 0;
};

/// "sigma x 1.01", as the table prints it.
std::string described(const defect&);

/// The scene's system with this one scheme, the defect planted; model, reference and claims stay those of the healthy
/// scheme but for the claims' own kinds. Throws std::invalid_argument where the scheme has nothing to plant it in.
subject planted(const report::scene&, std::string_view scheme, const defect&);

}  // namespace polhode::test
