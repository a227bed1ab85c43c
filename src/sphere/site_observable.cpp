// SPDX-License-Identifier: Apache-2.0
#include "sphere/site_observable.hpp"

#include <fmt/format.h>

namespace polhode {

std::optional<site_observable> site_observable_named(std::string_view name, int sites) {
  if (name == "energy") return site_observable{.energy = true};
  for (int site = 0; site < sites; ++site)
    for (int axis = 0; axis < 3; ++axis) {
      if (name == fmt::format("s{}_{}", site + 1, axis + 1) || name == fmt::format("mu_{}", 3 * site + axis + 1))
        return site_observable{.site = site, .axis = axis};
      if (name == fmt::format("s{}_{}^2", site + 1, axis + 1) || name == fmt::format("mu_{}^2", 3 * site + axis + 1))
        return site_observable{.site = site, .axis = axis, .power = 2};
    }
  return std::nullopt;
}

}  // namespace polhode
