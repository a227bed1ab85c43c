// SPDX-License-Identifier: Apache-2.0
// One number for the errors of all observables, that a slope can be asked of.
//
// Single errors cross zero or are lost in the sampling error, and the slowest of many slopes is slow by chance. So all
// observables are added up in the direction in which the errors lie: sum_f w_f f / size_f, an observable itself.
#pragma once

#include <span>
#include <vector>

#include "statistics/orders/squared_errors.hpp"

namespace polhode {

/// differences: of each observable, path by path; sizes: of the observables. The weights of one half of the paths are
/// the mean errors of the other half, so that no path chooses its own, at the finest level where these are `resolved`
/// standard errors in the mean square over the observables (else where they are most).
squared_errors along_their_errors(const std::vector<squared_errors>& differences, std::span<const double> sizes,
                                  double resolved);

}  // namespace polhode
