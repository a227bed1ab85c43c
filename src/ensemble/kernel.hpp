// Many paths of one scheme on one system, advanced together. The only virtual calls of the laboratory's loops are here:
// one per block of paths and chunk of steps.
#pragma once

#include <memory>
#include <span>
#include <vector>

namespace polhode {

/// Paths that advance together: one block. A multiple of every pack width in use.
inline constexpr int block_lanes = 16;

/// Increments of a block over a chunk of steps, [step][channel][lane] and [step][pair i<j][lane]; where all paths share
/// one noise, [step][channel] and [step][pair].
struct increment_view {
  double dt = 0;
  int steps = 0;
  bool shared = false;
  std::span<const double> dw;
  std::span<const double> area;  ///< empty where nobody asks for areas
};

class kernel {
 public:
  virtual ~kernel() = default;
  /// Advances the states, [component][lane], through all steps of the view.
  virtual void advance(std::span<double> states, const increment_view& increments) const = 0;
};

}  // namespace polhode
