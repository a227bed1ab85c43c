// SPDX-License-Identifier: Apache-2.0
#include "experiments/stability/breakage.hpp"

#include <array>
#include <cstddef>

namespace polhode {

std::string_view name_of(breakage b) {
  constexpr std::array<std::string_view, 6> names{"nothing", "step not solved", "not finite",
                                                  "Casimir", "energy range",    "mean energy"};
  return names[static_cast<std::size_t>(b)];
}

}  // namespace polhode
