// SPDX-License-Identifier: Apache-2.0
// The floor below which no error of a scheme falls: what rounding leaves of a state and of its energy.
//
// A few steps of the scene's finest dt through fixed noise are repeated at steps that differ a little, by 2^-10 in
// phase at the end. The exact result is smooth in dt, so that high differences over them are rounding alone
// (statistics/rounding_noise.hpp): no reference is needed, and every kernel is seen at the dt at which it is used. A
// state kept in single precision lies 10^8 times above the floor of one in double precision, whatever invariants are
// restored after it.
//
// A state that is off by |mu| e in a random direction of its d components has an energy that is off by |dh/dmu| |mu| e
// / sqrt(d), root mean square over the directions. Where parts of h cancel, or two vortices are close, that is far more
// than h e, whatever the scheme. So the energy is measured in units of the larger of both. Source: Higham, Accuracy and
// Stability of Numerical Algorithms, 2nd ed. (2002), section 1.6 (condition numbers).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "experiments/common/experiment.hpp"
#include "experiments/common/recorder.hpp"

namespace polhode {

struct rounding_floor {
  double state = 0;  ///< standard deviation over |mu|, in units of 2^-52
  double energy =
      0;  ///< over the larger of energy_size (levels.hpp) and energy_condition on the way, in the same units
};

/// |dh/dmu| |mu| / sqrt(d), root mean square over a block of states, [component][lane]. By central differences, right
/// to some digits; not finite where h is not.
double energy_condition(const model&, std::span<const double> states);
/// Its root mean square over the states between the steps of the noise: each adds its own rounding.
double condition_on_the_way(const model&, const kernel& scheme, std::vector<double> states,
                            const increment_view& noise);

/// Of the scheme on that subject, with its noise if it has some.
rounding_floor rounding_floor_of(const context&, const subject&, const scheme_entry&);

/// At most `floor_bound` units: measurement and verdict. Relative to 2^-52 per root of the number of steps.
inline constexpr double floor_bound = 16;
void report_floor(const std::string& claim, double units, recorder&);

}  // namespace polhode
