// SPDX-License-Identifier: Apache-2.0
// An integrator is tried before it is used. What runs inside this program does so in a process of its own: what it does
// wrong ends that process.
#pragma once

#include <string>

#include "foreign/integrator.hpp"

namespace polhode::foreign {

/// What is found out on the way. Neither is a fault.
struct probed {
  bool repeats = true;        ///< the same step twice has the same bits
  bool two_at_a_time = true;  ///< two threads at a time get what one gets
};

/// Opens the integrator on the problem and lets it step, with pages that must not be touched before and after each
/// array that it is handed. Throws refusal, or failure: it is killed by a signal, ends the program, hangs, throws,
/// writes beyond the states, or reads beyond an array.
probed probe(integrator&, const problem&);

/// Of one that has been tried: nanoseconds of a step of one path, the fastest of a few calls.
double cost_of_step(integrator&, const problem&);

}  // namespace polhode::foreign
