// SPDX-License-Identifier: Apache-2.0
// The step at which one candidate meets a tolerance: predicted, then measured.
#pragma once

#include "selection/select.hpp"

namespace polhode {

/// error = factor dt^order, from measurements in the asymptotic range.
struct error_law {
  double factor = 0, order = 0;
  double at(double dt) const;
  double step_for(double error) const;
};

struct prospect {
  candidate who;
  std::optional<error_law> law;
  double dt = 0, cost = 0;  ///< predicted
  std::string fault;        ///< why it is out; empty: it is not
};

/// What is seen from a step down to a tenth of it.
struct descent {
  double longest = 0;         ///< the step
  error_estimate at_longest;  ///< there
  double worst = 0;           ///< the largest upper bound at any of the steps, and between them
  double too_long = 0;        ///< the first step at which the tolerance is not met; 0: it is met at all
  double shortest = 0;        ///< down to which it was affordable to look
};

class search {
 public:
  search(const context&, const goal&, const goal_question&);

  /// The first error law of a candidate; on any thread.
  prospect predict(const candidate&) const;
  /// Its cost at the predicted dt; one thread, nothing else running.
  void price(prospect&) const;
  /// Measured at the predicted dt and at steps between that and a tenth of it, mended until the tolerance is met at all
  /// of them (no zero of the error's is taken for accuracy); nothing where that cannot be had.
  std::optional<choice> check(const prospect&, std::string& fault) const;

 private:
  double whole_steps(double dt) const;
  /// Steps between dt and dt/10, the longest first.
  std::vector<double> rungs_below(double dt) const;
  descent look_below(const candidate&, double dt, std::uint64_t seed) const;
  double longer_than(const descent& good, const std::optional<descent>& bad, double order) const;
  choice priced(const candidate&, double dt) const;
  choice found(const prospect&, const descent&) const;

  const context& context_;
  const goal& goal_;
  const goal_question& question_;
  double rate_;
};

}  // namespace polhode
