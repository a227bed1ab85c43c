// SPDX-License-Identifier: Apache-2.0
// Runs an experiment on a subject's schemes, those apart whose results are known already.
#pragma once

#include <string>
#include <vector>

#include "experiments/common/experiment.hpp"
#include "reports/model/result_store.hpp"
#include "run/ranks.hpp"
#include "run/shared_work.hpp"
#include "run/time_budget.hpp"

namespace polhode {

/// The subject with these of its schemes only.
subject restricted(subject, const std::vector<std::string>& schemes);

/// Where results are kept from run to run; null: nowhere. Those of some schemes never are.
struct kept_results {
  report::result_store* store = nullptr;
  std::vector<std::string> but_of = {};
  const ranks* among = nullptr;         ///< share the schemes, and the first keeps what they find; null: alone
  const shared_work* shared = nullptr;  ///< how, and what this one has found already; null: scheme by scheme in turn
  const time_budget* budget = nullptr;  ///< of what is computed; null: without a limit
};

/// What the experiment says of these of the subject's schemes, with the work that it was.
report::results computed(const experiment&, const context&, const std::vector<std::string>& schemes);

/// Appends what the experiment says: rows of no scheme first, then scheme by scheme in the subject's order, whether
/// they are computed now or come from the store. What is computed goes into the store. Relies on an experiment saying
/// the same of a scheme, and of none, whichever schemes run. Throws out_of_time, on all ranks, where one had none left.
void run_experiment(const experiment&, const context&, const kept_results&, report::results& out);

}  // namespace polhode
