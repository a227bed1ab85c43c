// SPDX-License-Identifier: Apache-2.0
// Records of bodies on their way, gathered block by block and handed over in pieces, so that memory stays flat.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "ensemble/kernel.hpp"

namespace polhode {

/// Successive records of the bodies of a block: [body][record][component].
struct recorded_bodies {
  std::int64_t first_body = 0, first_record = 0;
  int bodies = 0, records = 0;
  std::vector<double> values;
};

using record_sink = std::function<void(const recorded_bodies&)>;

/// Gathers the records of one block after another.
class block_record {
 public:
  block_record(int dimension, record_sink take) : dimension_(dimension), take_(std::move(take)) {}

  /// Of so many bodies, whose first record follows.
  void start(std::int64_t first_body, int bodies) {
    held_ = {first_body, 0, bodies, 0,
             std::vector<double>(static_cast<std::size_t>(bodies * records_at_once * dimension_))};
  }
  void add(std::span<const double> states) {
    for (int body = 0; body < held_.bodies; ++body)
      for (int k = 0; k < dimension_; ++k)
        held_.values[static_cast<std::size_t>((body * records_at_once + held_.records) * dimension_ + k)] =
            states[static_cast<std::size_t>(k * block_lanes + body)];
    if (++held_.records == records_at_once) hand_over();
  }
  void hand_over() {
    if (held_.records == 0) return;
    if (held_.records < records_at_once) close_ranks();
    take_(held_);
    held_.first_record += held_.records;
    held_.records = 0;
    held_.values.resize(static_cast<std::size_t>(held_.bodies * records_at_once * dimension_));
  }

 private:
  void close_ranks() {
    const auto row = static_cast<std::size_t>(held_.records * dimension_),
               room = static_cast<std::size_t>(records_at_once * dimension_);
    for (std::size_t body = 1; body < static_cast<std::size_t>(held_.bodies); ++body)
      std::copy_n(held_.values.begin() + static_cast<std::ptrdiff_t>(body * room), row,
                  held_.values.begin() + static_cast<std::ptrdiff_t>(body * row));
    held_.values.resize(static_cast<std::size_t>(held_.bodies) * row);
  }

  static constexpr int records_at_once = 64;  // before they are handed over

  int dimension_;
  record_sink take_;
  recorded_bodies held_;
};

}  // namespace polhode
