// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set, with AES instructions and without contraction of products and sums.
#include "ensemble/noise/normal_fill.hpp"
#include <polhode/flatten.hpp>
#include "platform/isa_entry.hpp"

extern "C" POLHODE_FLATTEN void POLHODE_ENTRY(polhode_fill_normals_ars_)(const polhode::normal_block& request) {
  polhode::fill<polhode::noise_generator::ars>(request);
}
