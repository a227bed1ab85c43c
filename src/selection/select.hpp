// SPDX-License-Identifier: Apache-2.0
// Which scheme, at which step, for this scene? The cheapest that is measured to meet the target.
//
// 1. Every scheme's error is measured at three steps in the asymptotic range: error = C dt^p.
// 2. Its cost is measured here and now (step_cost.hpp): ns a path and unit of time at the dt that C and p predict.
// 3. In the order of that cost the error is measured at the predicted dt and at steps from there down to a tenth of it;
//    the dt is mended until the upper bounds are within the tolerance at all of them, so that no error that happens to
//    vanish on its way to the other sign is taken for accuracy. The first two whose measured costs nobody can undercut
//    are the winner and the runner-up.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "selection/goal.hpp"

namespace polhode {

struct choice {
  std::string scheme;
  double dt = 0;
  double predicted = 0, checked = 0,
         bound = 0;  ///< error by the model, measured at dt; the largest upper bound from dt down
  double order = 0;  ///< p of the model
  double cost = 0, cost_low = 0, cost_high = 0;  ///< ns a path and unit of time
  double checked_to = 0;                         ///< the bound holds at every step looked at from dt down to this one
  std::vector<observable_error> observed = {};   ///< of averages, at dt: every observable, asked for or not
};

struct rejection {
  std::string scheme, reason;
};

struct selection {
  goal_question question;
  std::string unit;  ///< of errors and tolerance
  std::optional<choice> winner, runner_up;
  bool tied = false;              ///< the intervals of their costs overlap
  std::optional<choice> closest;  ///< where nothing meets the target; checked and bound are not numbers: not measured
  std::string reason;             ///< what stands in the way
  std::vector<rejection> rejected;
  std::vector<std::string> notes;
  std::vector<std::string> silent_on;  ///< of averages: observables that were not asked for
  /// Of the winner: the worst of all observables, or, where one is asked for, of the others.
  std::optional<observable_error> worst_observable;
  std::string snippet;  ///< a program against the installed headers; empty without a winner
};

/// require: casimir-exact, explicit, implicit, no-areas, monotone-energy (without noise the energy never rises at that
/// dt). Throws input_error on what cannot be asked of the scene.
selection select(const context&, const goal_question&, const std::vector<std::string>& require = {});

/// The names that `require` takes.
const std::vector<std::string>& requirements();

}  // namespace polhode
