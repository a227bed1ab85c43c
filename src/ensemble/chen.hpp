// SPDX-License-Identifier: Apache-2.0
// Increments of long steps from those of short ones.
#pragma once

#include <span>

#include "ensemble/kernel.hpp"
#include "ensemble/noise/noise_layout.hpp"

namespace polhode {

/// Chen's relation (polhode/increment.hpp) over groups of `factor` steps of a block: [step][channel][lane] and
/// [step][pair][lane]. An input without areas is a piecewise linear path.
void coarsen(const noise_layout&, const increment_view& fine, int factor, std::span<double> dw, std::span<double> area);

}  // namespace polhode
