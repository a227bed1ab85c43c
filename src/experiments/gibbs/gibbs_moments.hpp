// SPDX-License-Identifier: Apache-2.0
// What is observed of paths under a Gibbs law, and how it is held against that law.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "ensemble/model.hpp"
#include "experiments/common/recorder.hpp"
#include "sphere/closed_forms/gibbs.hpp"
#include "statistics/sample.hpp"

namespace polhode {

inline constexpr int observations = 4;        ///< of every path
inline constexpr double moment_margin = 0.1;  ///< of the standard deviation of the observable: how far a mean may lie
inline constexpr double ks_bound = 0.05;      ///< Kolmogorov-Smirnov distance allowed

/// Of a mean and its interval against the exact one.
report::verdict judge_mean(double exact, double margin, const interval_estimate&);

/// What is kept of every path: means over its observations, and the last energy.
struct path_means {
  std::vector<double> energy, square1, square3, energy2, last_energy;
  explicit path_means(std::size_t paths)
      : energy(paths), square1(paths), square3(paths), energy2(paths), last_energy(paths) {}
};

/// Adds one observation of a block of paths.
void observe(const model&, std::span<const double> states, int block, path_means&);

/// The mean of one observable: what it is compared with.
struct gibbs_moment {
  std::string observable;
  std::vector<double> path_means::*values;
  double exact, margin;
};

std::vector<gibbs_moment> moments_of(const gibbs_law&, double radius);

/// What is found for one scheme at the end of a batch.
struct gibbs_finding {
  std::vector<interval_estimate> means;
  interval_estimate ks;
};

gibbs_finding find(const gibbs_law&, const std::vector<gibbs_moment>&, const path_means&, int paths);

/// By widths alone: a third of the margins.
bool tight(const std::vector<gibbs_moment>&, const gibbs_finding&);

/// Measurements and verdicts of one scheme.
void report_finding(const std::vector<gibbs_moment>&, double dt, const gibbs_finding&, recorder&);

}  // namespace polhode
