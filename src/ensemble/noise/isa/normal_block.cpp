// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set, without contraction of products and sums, so that every one gives the same bits.
#include "ensemble/noise/normal_fill.hpp"
#include <polhode/flatten.hpp>
#include "platform/isa_entry.hpp"

extern "C" POLHODE_FLATTEN void POLHODE_ENTRY(polhode_fill_normals_)(const polhode::normal_block& request) {
  polhode::fill<polhode::noise_generator::philox>(request);
}
