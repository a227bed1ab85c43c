// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set, without contraction of products and sums, so that every one finds the same bins.
#include "ensemble/observing/direction_bins.hpp"

#include <limits>

#include "ensemble/kernel_of.hpp"
#include "ensemble/observing/sphere_bins.hpp"
#include <polhode/flatten.hpp>
#include "platform/isa_entry.hpp"

namespace polhode {
namespace {

pack greater(const pack& a, const pack& b) { return select(a > b, a, b); }

/// Scaled first: a body that runs away has a direction as long as it is finite.
void find(const double* states, int lane, direction_bins& out) {
  const auto mu = load_lanes<pack, 3>(states + lane);
  const pack finite(std::numeric_limits<double>::max());
  const pack a = magnitude(mu[0]), b = magnitude(mu[1]), c = magnitude(mu[2]);
  const pack largest = greater(a, greater(b, c));
  const auto known = a <= finite && b <= finite && c <= finite && largest > pack(0.0);
  const pack x = mu[0] / largest, y = mu[1] / largest, z = mu[2] / largest;
  const pack r = square_root(pack(x * x + y * y + z * z));
  const pack none(-1.0);
  select(known, longitude_bins::of(x, y, pack(z / r)), none)
      .copy_to(out.longitude.data() + lane, stdx::element_aligned);
  select(known, hemisphere_bins::of(pack(x / r), pack(y / r), pack(z / r)), none)
      .copy_to(out.hemisphere.data() + lane, stdx::element_aligned);
}

}  // namespace
}  // namespace polhode

extern "C" POLHODE_FLATTEN void POLHODE_ENTRY(polhode_find_bins_)(const double* states, polhode::direction_bins& out) {
  for (int lane = 0; lane < polhode::block_lanes; lane += static_cast<int>(polhode::pack::size()))
    polhode::find(states, lane, out);
}
