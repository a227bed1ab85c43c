// SPDX-License-Identifier: Apache-2.0
#include "ensemble/tangent_controls.hpp"

#include "platform/isa_entry.hpp"

namespace polhode {

void add_tangent_controls(const tangent_controls& request) { by_isa(POLHODE_ENTRIES(polhode_add_controls_))(request); }

}  // namespace polhode
