// SPDX-License-Identifier: Apache-2.0
// Processes that share a run. All make the same calls in the same order and hold the same results in the end; what one
// of them cannot do ends the run of all.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "reports/model/results.hpp"

namespace polhode {

class ranks {
 public:
  virtual ~ranks() = default;
  virtual int rank() const = 0;
  virtual int size() const = 0;
  /// What everybody says, by rank, everywhere.
  virtual std::vector<std::string> told_by_all(const std::string& mine) const = 0;
  /// The first one's, everywhere.
  virtual std::optional<report::results> of_the_first(const std::optional<report::results>&) const = 0;
  /// Everybody's, by rank.
  virtual std::vector<report::results> of_all(const report::results&) const = 0;
  /// To the first rank, which takes those of the others in their order, one at a time.
  virtual void to_the_first(const std::string& bytes, const std::function<void(const std::string&)>& take) const = 0;
};

}  // namespace polhode
