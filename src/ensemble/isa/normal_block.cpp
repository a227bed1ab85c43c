// Compiled once per instruction set, without contraction of products and sums, so that every one gives the same bits.
#include "ensemble/isa_entry.hpp"
#include "ensemble/normal_fill.hpp"

extern "C" [[gnu::flatten]] void POLHODE_ENTRY(polhode_fill_normals_)(const polhode::normal_block& request) {
  polhode::fill<polhode::noise_generator::philox>(request);
}
