// SPDX-License-Identifier: Apache-2.0
// What the readable reports share: in which order things stand, and how the verdicts count up.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "reports/model/names.hpp"
#include "reports/model/results.hpp"

namespace polhode::report {

struct tally {
  std::array<std::size_t, verdict_kinds.size()> counts{};
  void add(verdict_kind kind) { ++counts[static_cast<std::size_t>(kind)]; }
  std::size_t of(verdict_kind kind) const { return counts[static_cast<std::size_t>(kind)]; }
  std::size_t total() const;
};

tally count(const std::vector<verdict>&);

/// What matters most, in one short sentence.
std::string headline(const tally&);
/// "17 claims: 12 hold, 1 is refuted, 1 is inconclusive, 1 is not tried, 2 are skipped."
std::string sentence(const tally&);

/// Null where the experiment was not declared.
const experiment* find_experiment(const results&, std::string_view name);

std::vector<const verdict*> verdicts_of(const results&, std::string_view experiment);
std::vector<const fit*> fits_of(const results&, std::string_view experiment);
std::vector<std::string> claims_of(const std::vector<const verdict*>&);

}  // namespace polhode::report
