// How much memory this machine can still give, and how the C library takes it.
#pragma once

namespace polhode {

/// Bytes available without swapping; the control group's bound counts too. Infinity where nobody says.
double available_memory();

/// The C library keeps for itself what is freed until the program ends. By its own rule it gives large matrices back at
/// once, and the kernel clears the pages of the next one again. Before any thread; without effect where the C library
/// is another one than glibc.
void keep_freed_memory();

}  // namespace polhode
