// SPDX-License-Identifier: Apache-2.0
// What is written by hand, once per instruction set (isa/).
#pragma once

#include "platform/isa_entry.hpp"

namespace polhode::bench {

/// dt (1/I_1 - 1/I_2), theta dt (1/I_1 - 1/I_3), dt (1/I_3 - 1/I_2), theta.
struct heun_constants {
  double first, second, third, theta;
};

/// Paths that the kernel by hand takes: any multiple of this.
inline constexpr int paths_by_hand = 64;

}  // namespace polhode::bench

extern "C" {
/// Does so many rounds and returns the floating-point operations that were in them.
double polhode_bench_fma_chains_v2(long rounds);
double polhode_bench_fma_chains_v3(long rounds);
double polhode_bench_fma_chains_v4(long rounds);
double polhode_bench_fma_chains_portable(long rounds);

/// Heun without noise; states are [component][path].
void polhode_bench_heun_v2(double* states, int paths, int steps, const polhode::bench::heun_constants*);
void polhode_bench_heun_v3(double* states, int paths, int steps, const polhode::bench::heun_constants*);
void polhode_bench_heun_v4(double* states, int paths, int steps, const polhode::bench::heun_constants*);
void polhode_bench_heun_portable(double* states, int paths, int steps, const polhode::bench::heun_constants*);
}
