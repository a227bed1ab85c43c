// SPDX-License-Identifier: Apache-2.0
#include "ensemble/chen.hpp"

#include "platform/isa_entry.hpp"

POLHODE_DECLARE_ENTRIES(polhode_coarsen_, const polhode::noise_layout&, const polhode::increment_view&, int, double*,
                        double*);

namespace polhode {

void coarsen(const noise_layout& layout, const increment_view& fine, int factor, std::span<double> dw,
             std::span<double> area) {
  by_isa(POLHODE_ENTRIES(polhode_coarsen_))(layout, fine, factor, dw.data(), area.data());
}

}  // namespace polhode
