// SPDX-License-Identifier: Apache-2.0
// Observables of coupled spins or bodies that have a name.
#pragma once

#include <optional>
#include <string_view>

namespace polhode {

/// h, or a power of a component of one spin.
struct site_observable {
  bool energy = false;
  int site = 0, axis = 0, power = 1;
};

/// energy, a component s2_3 or mu_6 (the third of the second spin), or its square (s2_3^2, mu_6^2); nothing for another
/// name.
std::optional<site_observable> site_observable_named(std::string_view name, int sites);

}  // namespace polhode
