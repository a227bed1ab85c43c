// SPDX-License-Identifier: Apache-2.0
// Have recorded paths the stationary law of the equation on their sphere?
//
// Of every path the time in which it forgets its start is left out; the rest is cut into pieces of several relaxation
// times, whose means are as good as independent: Student's interval over pieces.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "experiments/common/recorder.hpp"
#include "problem/observables.hpp"
#include "recorded/transitions.hpp"

namespace polhode {

class recorded_law {
 public:
  explicit recorded_law(const subject&);

  void add(const recorded_transition&);
  void report(recorder&);

 private:
  struct piece {
    std::int64_t number = -1;
    double states = 0, times_began = 0;
    std::vector<double> sums;
  };
  struct finding {
    double mean = 0, low = 0, high = 0, exact = 0, deviation = 0, p = 1;
  };
  void close(piece&);
  std::optional<finding> find(std::size_t k) const;

  const subject& subject_;
  std::vector<observable> observables_;
  double relaxation_ = 0;  ///< 1 / gap
  double radius_ = 0;      ///< of the one sphere that is asked about
  std::string reason_;     ///< why nothing can be asked; empty: it can
  std::unordered_map<std::int64_t, piece> open_;
  std::vector<std::vector<double>> means_;  ///< [observable][piece]
};

}  // namespace polhode
