// SPDX-License-Identifier: Apache-2.0
// One register of doubles, in the compiler's own vectors: no inline function that the linker could merge with its
// namesake of another instruction set.
#pragma once

namespace polhode::bench {

#if defined(__AVX512F__)
constexpr int lane_count = 8;
#elif defined(__AVX__)
constexpr int lane_count = 4;
#else
constexpr int lane_count = 2;
#endif
typedef double lanes __attribute__((vector_size(8 * lane_count)));

}  // namespace polhode::bench
