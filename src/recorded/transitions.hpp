// SPDX-License-Identifier: Apache-2.0
// From states as they were recorded to pairs of successive ones.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <unordered_map>
#include <vector>

#include "recorded/recording.hpp"

namespace polhode {

struct recorded_transition {
  std::int64_t path;
  std::span<const double> start, before, after;  ///< the path's first state, and two successive ones
  double began, time, dt;                        ///< the path's first time, that of the state after, and the interval
};

/// Intervals between successive states, as classes of those that are equal but for rounding; how many there were of
/// each.
using interval_counts = std::map<double, std::uint64_t>;

/// Remembers the last state of every path.
class transitions {
 public:
  transitions(const recording& r, std::function<void(const recorded_transition&)> take)
      : recording_(r), take_(std::move(take)) {}

  /// Throws input_error where time does not go on.
  void add(const recorded_state&);

  std::size_t paths() const { return last_.size(); }
  std::uint64_t count() const { return count_; }
  const interval_counts& intervals() const { return intervals_; }

 private:
  struct path_state {
    double began, time;
    std::vector<double> start, mu;
  };
  double interval_class(double dt, double time) const;

  const recording& recording_;
  std::function<void(const recorded_transition&)> take_;
  std::unordered_map<std::int64_t, path_state> last_;
  interval_counts intervals_;
  std::uint64_t count_ = 0;
};

}  // namespace polhode
