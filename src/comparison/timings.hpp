// Has a scheme become dearer or cheaper, beyond what two runs of one program differ by?
//
// A cost is taken in units of its run's yardstick, a loop that never changes and was timed beside it. Its change from
// one run to the other is d = log(after / before), one for each dt. Those of a scheme move together where its step has
// changed: their median D decides, against
//
//   threshold = between_runs + z sqrt(s^2 + m^2 / n),
//
// s: standard error of D from how the n changes scatter, m: the median of their standard errors by their own intervals
// (slots that lie apart in each run), z: the two-sided quantile at level 0.01 over the number of groups. between_runs:
// what a whole run's timings of a scheme differ by from another's of the same program (placement of code and memory,
// neighbours that strain one kind of loop more than another), measured on a busy machine. What all schemes (five or
// more) have in common is taken out first, and told once where it is above `of_all`: it is the machine's, or that of
// what they share. Runs with noise and without
// (the energy law) are two groups of a scheme, told as one where both have moved. A cost that moves apart from its
// scheme's by more than `apart`, besides its interval, is told too, all of a scheme in one line. What follows from
// costs (cost_to_reach, cost_of_next) is not compared again.
#pragma once

#include "reports/model/comparison.hpp"
#include "reports/model/results.hpp"

namespace polhode {

inline constexpr double between_runs = 0.02, of_all = 0.1, apart = 0.15;  // of log(cost)

/// Appends a change a scheme, or says why timings are left out (settings that differ are known already).
void compare_timings(const report::results& before, const report::results& after, report::comparison& out);

}  // namespace polhode
