// SPDX-License-Identifier: Apache-2.0
// The observables of experiment weak whose true mean at the horizon is known, and those means.
#pragma once

#include <array>
#include <vector>

#include "experiments/laws/transfer_report.hpp"

namespace polhode {

inline constexpr std::array weak_observables{"energy", "pi1", "pi2", "pi3", "pi1^2", "pi2^2", "pi3^2", "exp(pi3)"};

/// Of an observable's size: how well a true mean is known at least, where the accuracy asked for is out of reach.
inline constexpr double usable_truth = 1e-7;

struct true_means {
  std::vector<error_column> columns;
  std::vector<sphere_function> functions;
  std::vector<double> exact, uncertainty;

  /// The same as what an operator is asked for; accuracy: of each error.
  transfer_target target(double accuracy) const;
};

Eigen::Vector3d start_of(const subject&);

/// Leaves the order open in an observable whose mean is not known.
true_means true_means_of(const subject&, report::results& out);

}  // namespace polhode
