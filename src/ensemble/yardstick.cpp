// SPDX-License-Identifier: Apache-2.0
#include "ensemble/yardstick.hpp"

#include "platform/isa_entry.hpp"

namespace polhode {

void run_yardstick(const yardstick_loop& loop) { by_isa(POLHODE_ENTRIES(polhode_yardstick_))(loop); }

}  // namespace polhode
