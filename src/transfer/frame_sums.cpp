// SPDX-License-Identifier: Apache-2.0
#include "transfer/frame_sums.hpp"

#include "platform/isa_entry.hpp"

namespace polhode {

void add_frames(const frame_sums& request) { by_isa(POLHODE_ENTRIES(polhode_add_frames_))(request); }

}  // namespace polhode
