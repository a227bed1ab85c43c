// SPDX-License-Identifier: Apache-2.0
// How processes share the schemes of some experiments: a whole experiment for each as far as may be, as those who share
// one draw the same noise and solve the same references.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "experiments/common/experiment.hpp"
#include "run/ranks.hpp"
#include "run/time_budget.hpp"

namespace polhode {

/// What a scheme of an experiment is expected to cost.
struct scheme_cost {
  std::string experiment, scheme;
  double cpu_seconds = 0;
};

/// By rank, the schemes that it computes of one experiment.
using dealt_schemes = std::vector<std::vector<std::string>>;

/// The dearest experiments first, each to the ranks with least to do so far: to one, or to as many as its share of the
/// whole. Among these its schemes in the same way.
std::map<std::string, dealt_schemes> deal(std::span<const scheme_cost>, int ranks);

/// What was dealt, and what this process has found of its part, as far as its time reached.
struct shared_work {
  std::map<std::string, dealt_schemes> dealt;
  std::map<std::string, report::results> found;
};

/// As the first process expects them, everywhere.
std::vector<scheme_cost> agreed(const std::vector<scheme_cost>&, const ranks&);

/// Experiments as processes share them: those of the next minutes together, so that not more is lost with a run that is
/// killed. What times the machine or reads what others found is left to be shared by itself.
class sharing {
 public:
  /// Null or one rank: nothing is shared. The rest outlives it.
  sharing(std::span<const experiment> experiments, std::span<const scheme_cost> costs, const ranks* among,
          const time_budget* budget)
      : experiments_(experiments), costs_(costs), among_(among), budget_(budget) {}

  /// The share with experiment i in it, computed now where it begins one; null: it is in none. Tells the processor
  /// seconds of the share that are done, all processes together, as far as this one knows.
  const shared_work* of(std::size_t i, const context&, const std::function<void(double seconds)>& tell);

 private:
  std::span<const experiment> next(std::size_t first) const;
  shared_work computed_now(std::span<const experiment>, const context&, const std::function<void(double)>& tell) const;

  std::span<const experiment> experiments_;
  std::span<const scheme_cost> costs_;
  const ranks* among_;
  const time_budget* budget_;
  shared_work now_;
  std::size_t end_ = 0;  ///< of the share
};

}  // namespace polhode
