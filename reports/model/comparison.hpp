// SPDX-License-Identifier: Apache-2.0
// Two results side by side: what differs beyond noise. Plain values.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace polhode::report {

enum class change_kind {
  worse,     ///< a claim is refuted that was not, or an error has grown: a regression
  unsure,    ///< a claim that held is inconclusive now, or is made no longer
  better,    ///< the reverse of either
  different  ///< a number that is no error, or a timing, has moved
};

/// One claim or one number. Texts are verdicts, or say why a number is missing.
struct change {
  change_kind kind = change_kind::different;
  std::string experiment, scheme, what;
  std::optional<double> dt;
  std::optional<double> before, before_low, before_high, after, after_low, after_high;
  std::string text_before, text_after;
};

struct comparison {
  std::string scene;
  std::vector<std::string> settings;  ///< what differs in machine, build or settings: "seed: 1, now 2"
  std::vector<change> changes;
  std::size_t claims = 0, numbers = 0, timings = 0;  ///< compared
  std::size_t without_interval = 0;                  ///< sampled numbers whose noise is unknown: not compared
  std::string timings_left_out;                      ///< why timings were not compared; empty: they were
};

}  // namespace polhode::report
