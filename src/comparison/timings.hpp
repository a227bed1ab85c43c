// SPDX-License-Identifier: Apache-2.0
// Has a scheme become dearer or cheaper, beyond what two runs of one program differ by?
//
// A cost is taken in units of its run's yardstick, a loop that never changes and was timed beside it. Its change from
// one run to the other is d = log(after / before), one for each dt. Those of a scheme move together where its step has
// changed: their median D decides, against
//
//   threshold = between_runs + strain + z sqrt(s^2 + (shared m)^2),
//
// s: standard error of D from how the changes scatter, m: the median of their standard errors by their own intervals
// (slots that lie apart in each run), which the dt of a scheme share in part, as a busy neighbour strains one kind of
// loop more than another for as long as it is there; z: the two-sided quantile at level 0.01 over the number of groups.
// strain: a processor shared with other work slows no step by more than the yardstick, which has the most operations in
// flight, and some hardly at all; so D may move by as much as the yardstick (its median, or its upper quartile) has
// moved from run to run, and by no more than three times the largest but one that is seen, of seven schemes or more. It
// is none where both runs found the machine in the same state.
// What all schemes (five or more) have in common is taken out first, and told once where it is above `of_all` and what
// the yardstick has moved by: it is the machine's, or that of what they share. Runs with noise and without (the energy
// law) are two groups of a scheme, told as one where both have moved. A cost that moves apart from its scheme's by more
// than `apart`, besides its interval, is told too, all of a scheme in one line. What follows from costs (cost_to_reach,
// cost_of_next) is not compared again.
//
// Seen on a quiet machine (both processors threads of one core): of 1,400 timings in 20 pairs of runs none is called
// changed, medians D of one program within 0.001, and a step 5 % slower is found in 20 of 20. With other work beside, 0
// of 1,400 as well, and the slower step is found in 6 of 20.

#pragma once

#include "reports/model/comparison.hpp"
#include "reports/model/results.hpp"

namespace polhode {

inline constexpr double between_runs = 0.01, shared = 0.6, of_all = 0.25,
                        apart = 0.15;  // of log(cost); shared: a share

/// Appends a change a scheme, or says why timings are left out (settings that differ are known already).
void compare_timings(const report::results& before, const report::results& after, report::comparison& out);

}  // namespace polhode
