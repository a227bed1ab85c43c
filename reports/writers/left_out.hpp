// SPDX-License-Identifier: Apache-2.0
// What a run did not compute, as rows of a table.
#pragma once

#include <string>
#include <vector>

#include "reports/model/results.hpp"

namespace polhode::report {

struct left_out {
  enum class kind { skip, saving, reuse } kind;
  std::string experiment, schemes, reason;
  std::string saved;  ///< empty where it is not known
};

/// The skips, then the savings, then what was reused: one row an experiment and time of computation.
std::vector<left_out> left_out_of(const results&);

/// "This run computed …", in one sentence or two.
std::string work_sentence(const results&);

}  // namespace polhode::report
