// SPDX-License-Identifier: Apache-2.0
// Many paths of one scheme with the tangents of their flow.
#pragma once

#include <span>

#include "ensemble/kernel.hpp"

namespace polhode {

/// Tangents of each path: enough for the growth of lengths and of areas.
inline constexpr int tangent_vectors = 2;

class tangent_kernel {
 public:
  virtual ~tangent_kernel() = default;
  virtual double dt() const = 0;
  /// Advances the states, [component][lane], through all steps of the view, as the kernel of the scheme would, and the
  /// tangents, [vector][component][lane], by the derivative of those very steps. Every lane has its own noise, or there
  /// is none. Tangents grow or shrink without bound: whoever calls often enough brings them back to length one.
  virtual void advance(std::span<double> states, std::span<double> tangents, const increment_view&) const = 0;
};

}  // namespace polhode
