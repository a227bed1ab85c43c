// SPDX-License-Identifier: Apache-2.0
// States with any number of tangents through the steps of a noise: by the derivative of a scheme's own step, or by
// differences of neighbours, for a kernel that has no derivative. The two know nothing of each other.
#pragma once

#include <memory>
#include <span>

#include "ensemble/tangent_kernel.hpp"

namespace polhode {

class tangent_flow {
 public:
  virtual ~tangent_flow() = default;
  virtual double dt() const = 0;
  /// States [component][lane], tangents [vector][component][lane], of about length one: through all steps of the view.
  virtual void advance(std::span<double> states, std::span<double> tangents, const increment_view&) const = 0;
};

/// Two tangents at a time, each pair with the states anew. An even number of tangents.
std::unique_ptr<tangent_flow> derivative_flow(std::unique_ptr<tangent_kernel>);

/// Neighbours at `distance` times the tangents (Benettin, Galgani, Giorgilli, Strelcyn, Meccanica 15 (1980) 9).
std::unique_ptr<tangent_flow> neighbour_flow(std::unique_ptr<kernel>, double distance);

}  // namespace polhode
