// SPDX-License-Identifier: Apache-2.0
// Means of a scheme's long paths against those that a system knows of its Gibbs law.
#pragma once

#include <vector>

#include "experiments/common/recorder.hpp"
#include "experiments/gibbs/gibbs_moments.hpp"
#include "problem/observables.hpp"

namespace polhode {

struct known_mean {
  double exact, deviation;  ///< of the observable under the law
  double margin() const { return moment_margin * deviation; }
};

/// Of energy, of components, of squares: a claim holds if it holds of each of its means; the mean that decides is
/// named. found: intervals of the means, one an observable.
void report_known_means(const std::vector<observable>&, const std::vector<known_mean>&, double dt,
                        const std::vector<interval_estimate>& found, recorder&);

}  // namespace polhode
