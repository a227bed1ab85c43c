// The floor below which no error of a scheme falls: what rounding leaves of a state and of its energy.
//
// A few steps of the scene's finest dt through fixed noise are repeated at steps that differ a little, by 2^-10 in
// phase at the end. The exact result is smooth in dt, so that high differences over them are rounding alone
// (statistics/rounding_noise.hpp): no reference is needed, and every kernel is seen at the dt at which it is used. A
// state kept in single precision lies 10^8 times above the floor of one in double precision, whatever invariants are
// restored after it.
#pragma once

#include <string>

#include "experiments/common/experiment.hpp"
#include "experiments/common/recorder.hpp"

namespace polhode {

struct rounding_floor {
  double state = 0, energy = 0;  ///< standard deviation over that of |mu| and of the energy, in units of 2^-52
};

/// Of the scheme on that subject, with its noise if it has some.
rounding_floor rounding_floor_of(const context&, const subject&, const scheme_entry&);

/// At most `floor_bound` units: measurement and verdict. Relative to 2^-52 per root of the number of steps.
inline constexpr double floor_bound = 16;
void report_floor(const std::string& claim, double units, recorder&);

}  // namespace polhode
