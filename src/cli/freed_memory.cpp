// SPDX-License-Identifier: Apache-2.0
#include "cli/freed_memory.hpp"

#include <limits>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace polhode::cli {

void keep_freed_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
  mallopt(M_ARENA_MAX, 1);  // others hold 64 MB at most, and give back what is above
#endif
}

}  // namespace polhode::cli
