// Has a scheme become dearer or cheaper, beyond what two runs of one program differ by?
//
// A cost is taken in units of its run's yardstick, a loop that never changes and was timed beside it. Its change from
// one run to the other is d = log(after / before), one for each dt. Those of a scheme move together where its step has
// changed: their median D decides, against
//
//   threshold = between_runs + z sqrt(s^2 + (shared m)^2),
//
// s: standard error of D from how the changes scatter, m: the median of their standard errors by their own intervals
// (slots that lie apart in each run), which the dt of a scheme share in part, as a busy neighbour strains one kind of
// loop more than another for as long as it is there; z: the two-sided quantile at level 0.01 over the number of groups.
// What all schemes (five or more) have in common is taken out first, and told once where it is above `of_all`: it is
// the machine's, or that of what they share. Runs with noise and without (the energy law) are two groups of a scheme,
// told as one where both have moved. A cost that moves apart from its scheme's by more than `apart`, besides its
// interval, is told too, all of a scheme in one line. What follows from costs (cost_to_reach, cost_of_next) is not
// compared again.
//
// between_runs and shared come from 60 runs of one program on two processors with a load of 15 to 20: in 20 pairs none
// of 520 groups (4,940 timings) is called changed, in ten others one of 260; of steps 5 % slower about half are found
// there. On a quiet machine the intervals are narrower, and so is the threshold. Under a load of 27, timings of seven
// schemes alone gave 15 of 280, all without noise, before these were timed four times as long.

#pragma once

#include "reports/model/comparison.hpp"
#include "reports/model/results.hpp"

namespace polhode {

inline constexpr double between_runs = 0.015, shared = 0.6, of_all = 0.25,
                        apart = 0.15;  // of log(cost); shared: a share

/// Appends a change a scheme, or says why timings are left out (settings that differ are known already).
void compare_timings(const report::results& before, const report::results& after, report::comparison& out);

}  // namespace polhode
