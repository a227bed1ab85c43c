// SPDX-License-Identifier: Apache-2.0
// What the inner loops have done since the program began: what was skipped is shown by these, not by words.
#pragma once

#include <cstdint>

namespace polhode {

struct work_counters {
  std::uint64_t normals = 0;     ///< drawn, lanes without a body included
  std::uint64_t path_steps = 0;  ///< steps of lanes
  std::uint64_t kernels = 0;     ///< calls of a kernel: a block of paths through a chunk of steps
};

work_counters work_so_far();

void count_normals(std::uint64_t);
/// One call of a kernel, of the scheme of that name.
void count_path_steps(std::uint64_t, const char* scheme);

}  // namespace polhode
