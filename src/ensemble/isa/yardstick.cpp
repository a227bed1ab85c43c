// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set.
#include "ensemble/yardstick.hpp"

#include <polhode/scalar.hpp>
#include <polhode/simd.hpp>

#include "ensemble/kernel.hpp"
#include <polhode/flatten.hpp>
#include "platform/isa_entry.hpp"

namespace polhode {
namespace {

constexpr int width = static_cast<int>(pack::size());

pack at(const double* from) {
  pack out;
  out.copy_from(from, stdx::element_aligned);
  return out;
}

/// One turn of three numbers by shears, which keep them bounded.
void shear(double* states, const double* row, int lane) {
  pack x = at(states + lane), y = at(states + block_lanes + lane), z = at(states + 2 * block_lanes + lane);
  const pack a = at(row + lane), b = at(row + block_lanes + lane), c = at(row + 2 * block_lanes + lane);
  x += a * y;
  y -= a * x;
  y += b * z;
  z -= b * y;
  z += c * x;
  x -= c * z;
  const pack excess = x * x + y * y + z * z - pack(1.0),
             scale = pack(1.0) - excess * (pack(0.5) - pack(0.375) * excess);
  (scale * x).copy_to(states + lane, stdx::element_aligned);
  (scale * y).copy_to(states + block_lanes + lane, stdx::element_aligned);
  (scale * z).copy_to(states + 2 * block_lanes + lane, stdx::element_aligned);
}

/// Four rounds of products in 32 bits.
void mix(std::uint32_t* mixed) {
  for (int lane = 0; lane < block_lanes; ++lane) {
    std::uint32_t a = mixed[lane], b = mixed[block_lanes + lane];
    for (int round = 0; round < 4; ++round) {
      const std::uint64_t product = std::uint64_t{0xd256d193U} * a;
      a = static_cast<std::uint32_t>(product >> 32) ^ b ^ 0x9e3779b9U;
      b = static_cast<std::uint32_t>(product);
    }
    mixed[lane] = a;
    mixed[block_lanes + lane] = b;
  }
}

}  // namespace
}  // namespace polhode

extern "C" POLHODE_FLATTEN void POLHODE_ENTRY(polhode_yardstick_)(const polhode::yardstick_loop& loop) {
  using namespace polhode;
  for (int i = 0; i < loop.steps; ++i) {
    const double* row = loop.table + i % yardstick_rows * 3 * block_lanes;
    for (int lane = 0; lane < block_lanes; lane += width) shear(loop.states, row, lane);
    mix(loop.mixed);
  }
}
