// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/measure.hpp"

namespace polhode::bench {

/// Prints what the timings of one run say beside each other; rows of what did not run are left out.
void print_summary(const timings&);

}  // namespace polhode::bench
