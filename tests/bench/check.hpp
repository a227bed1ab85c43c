// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace polhode::bench {

/// Holds every yardstick to what it stands beside: the same states, or the same solution. Says what disagrees; true if
/// nothing does.
bool yardsticks_agree();

}  // namespace polhode::bench
