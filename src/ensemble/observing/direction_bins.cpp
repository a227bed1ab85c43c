// SPDX-License-Identifier: Apache-2.0
#include "ensemble/observing/direction_bins.hpp"

#include "platform/isa_entry.hpp"

namespace polhode {

void find_bins(const double* states, direction_bins& out) { by_isa(POLHODE_ENTRIES(polhode_find_bins_))(states, out); }

}  // namespace polhode
