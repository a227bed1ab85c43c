// SPDX-License-Identifier: Apache-2.0
// What a reference by projection answers.
#pragma once

#include <optional>
#include <string>

namespace polhode {

struct reference_value {
  std::optional<double> value{};  ///< absent where the question has no answer of this kind
  double uncertainty = 0;         ///< proved, or what three degrees say; never below rounding
  int degree = 0;
  std::string reason{};    ///< empty if converged to the tolerance; else one sentence
  bool forgotten = false;  ///< an expectation after so long a time that it is taken from the stationary law
  bool relaxed = false;    ///< an expectation of which only the constant was left before the time was over

  bool converged() const { return value && reason.empty(); }
};

}  // namespace polhode
