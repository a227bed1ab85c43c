// SPDX-License-Identifier: Apache-2.0
// What a run leaves open, in the report's words: see report::verdict_kind.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "experiments/common/experiment.hpp"

namespace polhode {

/// A claim that these schemes make and that cannot be decided here: inconclusive for each of them.
void leave_open(std::span<const scheme_entry>, std::string_view experiment, std::string_view claim,
                const std::string& reason, report::results& out);

/// A claim that this effort leaves out by plan.
void leave_untried(std::span<const scheme_entry>, std::string_view experiment, std::string_view claim,
                   const std::string& reason, report::results& out);

/// What trying a claim takes of every scheme, against what each effort affords, in the same unit.
struct dear_claim {
  std::string_view experiment, claim;
  std::string what;  ///< "forgetting the start", …
  std::string unit;  ///< "path-steps a scheme", …
  double work;
  std::function<double(effort)> affordable;
};

/// Whether this effort affords the claim. If not, the report says so: not tried where a higher effort does, else
/// inconclusive for each of these schemes.
bool affords(const context&, std::span<const scheme_entry>, const dear_claim&, report::results& out);

}  // namespace polhode
