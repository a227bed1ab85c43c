// SPDX-License-Identifier: Apache-2.0
// What is exact where weak errors are sampled: means on a product of two spheres, and the driven equation held to them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "experiments/common/experiment.hpp"
#include "problem/observables.hpp"
#include "sphere/galerkin/reference_value.hpp"
#include "statistics/orders/squared_errors.hpp"

namespace polhode {

struct exact_means {
  std::vector<reference_value> of;  ///< each observable; without a value where its mean is not resolved
  std::string reason = {};          ///< why none is known; empty: some are, or the system lives on no such product
  bool known() const;
};

/// E[f] at that time from the scene's momentum, to 1e-4 of an observable's size: below what sampling tells.
exact_means exact_means_of(const subject&, const std::vector<observable>&, double time);

/// Means of the driven equation, which every sampled error is taken against, over the exact ones.
struct held_truth {
  struct mean {
    std::string observable;
    mean_and_error sampled;
    reference_value exact;
    double z;  ///< distance beyond the reference's own uncertainty, in standard errors
  };
  std::vector<mean> means;
  double limit = 0;  ///< on |z|: beyond it lie all healthy runs but one in a million

  bool agrees() const;
  std::string text() const;  ///< of the largest |z|; empty without means
};

/// values: [observable] of independent paths, all levels alike.
held_truth held_to(const exact_means&, const std::vector<observable>&, const std::vector<squared_errors>& values);

/// A row a mean: the true one, the sampled one, and how far these are apart.
void report_truth(const held_truth&, report::results& out);

/// A verdict that rests on the driven equation decides nothing where that is not at the exact means.
void hold_to(const held_truth&, report::verdict&);

}  // namespace polhode
