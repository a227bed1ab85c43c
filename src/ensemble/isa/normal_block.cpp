// Compiled once per instruction set, without contraction of products and sums, so that every one gives the same bits.
#include "ensemble/flatten.hpp"
#include "ensemble/isa_entry.hpp"
#include "ensemble/normal_fill.hpp"

extern "C" POLHODE_FLATTEN void POLHODE_ENTRY(polhode_fill_normals_)(const polhode::normal_block& request) {
  polhode::fill<polhode::noise_generator::philox>(request);
}
