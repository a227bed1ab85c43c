// SPDX-License-Identifier: Apache-2.0
// How much memory this machine can still give.
#pragma once

namespace polhode {

/// Bytes available without swapping; the control group's bound counts too. Infinity where nobody says.
double available_memory();

}  // namespace polhode
