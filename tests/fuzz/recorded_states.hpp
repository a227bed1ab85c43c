// SPDX-License-Identifier: Apache-2.0
// States as a reader of recordings hands them over, and the pairs of successive ones that are made of them.
#pragma once

#include <cmath>
#include <istream>
#include <vector>

#include "fuzz.hpp"
#include "recorded/recording_kinds.hpp"
#include "recorded/transitions.hpp"

namespace polhode::fuzz {

struct state {
  std::int64_t path;
  double time;
  std::vector<double> mu;
  bool operator==(const state&) const = default;
};

using states_reader = recording_size (*)(const recording&, std::istream&, const state_sink&);

inline std::vector<state> states_in(const recording& r, states_reader read, std::istream& in) {
  std::vector<state> out;
  read(r, in, [&](const recorded_state& s) { out.push_back({s.path, s.time, {s.mu.begin(), s.mu.end()}}); });
  return out;
}

/// Their pairs, or a refusal.
inline void follow(const recording& r, const std::vector<state>& states) {
  taken([&] {
    transitions pairs(r, [](const recorded_transition& t) {
      demand(t.dt > 0 && std::isfinite(t.dt), "an interval is a finite number above 0");
    });
    for (const auto& s : states) pairs.add({s.path, s.time, s.mu, 1});
    return pairs.count();
  });
}

}  // namespace polhode::fuzz
