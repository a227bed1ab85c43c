// What a path costs per unit of time, each step measured once.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "experiments/step_cost.hpp"

namespace polhode {

/// Per path and unit of time.
struct price {
  double steps = 0, normals = 0, ns = 0, low = 0, high = 0;
};

class price_list {
 public:
  explicit price_list(const context&);

  /// A combination over step sizes pays for all its runs, with dt, dt/2, …. None for a scheme that is not run here.
  std::optional<price> of_path(const std::string& scheme, double dt, bool silent);

 private:
  std::optional<step_cost> of_step(const std::string& scheme, double dt, bool silent);

  const context& context_;
  subject still_;  ///< without noise
  std::map<std::tuple<std::string, double, bool>, step_cost> known_;
};

}  // namespace polhode
