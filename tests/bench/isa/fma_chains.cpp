// SPDX-License-Identifier: Apache-2.0
// The peak of one core: independent chains of x <- x a + b, more of them than latency times units asks for. Where there
// is no fused operation (v2) it is a product and a sum.
#include "bench/by_hand.hpp"
#include "bench/isa/lanes.hpp"

extern "C" double POLHODE_ENTRY(polhode_bench_fma_chains_)(long rounds) {
  using polhode::bench::lanes;
  constexpr int chains = 14;
  lanes x[chains], a = lanes{} + 0.5, b = lanes{} + 1.0;
  for (int i = 0; i < chains; ++i) x[i] = lanes{} + i;
  for (long round = 0; round < rounds; ++round)
#pragma GCC unroll 14
    for (int i = 0; i < chains; ++i) x[i] = x[i] * a + b;
  lanes sum = x[0];
  for (int i = 1; i < chains; ++i) sum += x[i];
  asm volatile("" : : "m"(sum));  // somebody could look at it
  return 2.0 * chains * polhode::bench::lane_count * static_cast<double>(rounds);
}
