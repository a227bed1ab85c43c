// SPDX-License-Identifier: Apache-2.0
// The whole law of what a system knows the distribution of (capabilities::gibbs_marginals), from long paths.
//
// Of each path ten values, about two of the longest autocorrelation times apart: as n_eff independent ones, n (1 - r) /
// (1 + r) with r = exp(-1.95), the correlation of neighbours.
#pragma once

#include <span>
#include <vector>

#include "experiments/common/recorder.hpp"
#include "problem/subject.hpp"

namespace polhode {

/// Of one scheme.
class marginal_samples {
 public:
  static constexpr int draws = 10;  ///< of a path

  marginal_samples(const subject&, int paths);

  /// look: of so many looks at a path, equally far apart, 0 the first; others than every tenth part are passed over.
  void keep(std::span<const double> mu, std::size_t path, int look, int looks);
  /// Kolmogorov-Smirnov distances over the first paths, one a marginal; times_averaged: autocorrelation times of all
  /// looks at a path.
  std::vector<interval_estimate> distances(int paths, double times_averaged) const;

 private:
  const std::vector<known_marginal>& laws_;
  std::vector<std::vector<double>> values_;  ///< [marginal][path, draw]
};

/// By widths alone: half the bound.
bool tight_distances(const std::vector<interval_estimate>&);

void report_marginals(const subject&, double dt, const std::vector<interval_estimate>&, recorder&);

}  // namespace polhode
