// SPDX-License-Identifier: Apache-2.0
// What becomes of memory that the program frees.
#pragma once

namespace polhode::cli {

/// The C library keeps it until the program ends. By its own rule it gives large matrices back at once, and the kernel
/// clears the pages of the next one again. Before any thread; without effect where the C library is not glibc.
void keep_freed_memory();

}  // namespace polhode::cli
