// SPDX-License-Identifier: Apache-2.0
// What a path costs per unit of time, each step measured once.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "experiments/work_precision/step_cost.hpp"

namespace polhode {

/// Per path and unit of time.
struct price {
  double steps = 0, normals = 0, ns = 0, low = 0, high = 0;
};

class price_list {
 public:
  explicit price_list(const context&);

  /// What of_path will be asked; a scheme that is not run here is passed over.
  void want(const std::string& scheme, double dt, bool silent);
  /// Measures all that is wanted, interleaved (step_cost.hpp).
  void measure();

  /// A combination over step sizes pays for all its runs, with dt, dt/2, …. None for what was not wanted.
  std::optional<price> of_path(const std::string& scheme, double dt, bool silent) const;
  /// The same where areas are those of a path: with the normals of the cells that they are made of (path_cells.hpp).
  std::optional<price> of_path_with_cells(const std::string& scheme, double dt) const;
  const yardstick_time& yardstick() const { return yardstick_; }

 private:
  using key = std::tuple<std::string, double, bool>;

  subject still_;  ///< without noise
  context noisy_context_, still_context_;
  std::map<key, step_cost> known_;
  yardstick_time yardstick_;
  double ns_per_normal_ = 0;
};

}  // namespace polhode
