// SPDX-License-Identifier: Apache-2.0
// Heun without noise for a rigid body, written for this case alone: packs in registers, several in flight, 1/I_2 taken
// from every 1/I (Pi x Pi = 0), constants outside the loop.
#include "bench/by_hand.hpp"
#include "bench/isa/lanes.hpp"

namespace {

using polhode::bench::heun_constants;
using polhode::bench::lane_count;
using polhode::bench::lanes;

constexpr int in_flight = lane_count == 8 ? 8 : 4;

struct triple {
  lanes x, y, z;
};

/// dt a(Pi) = dt (Omega + theta Pi x Omega), Omega_2 = 0.
[[gnu::always_inline]] inline triple generator(const triple& p, const heun_constants& c) {
  const lanes w1 = p.x * c.first, w3 = p.z * c.third, ty = p.y * c.theta;
  return {ty * w3 + w1, (p.x * c.second) * p.z, w3 - ty * w1};
}

[[gnu::always_inline]] inline void step(triple& p, const heun_constants& c) {
  const triple a = generator(p, c);
  const triple q{(p.x + p.y * a.z) - p.z * a.y, (p.y + p.z * a.x) - p.x * a.z, (p.z + p.x * a.y) - p.y * a.x};
  const triple s{p.x + q.x, p.y + q.y, p.z + q.z}, b = generator(q, c);
  p.x = ((s.x + q.y * b.z) - q.z * b.y) * 0.5;
  p.y = ((s.y + q.z * b.x) - q.x * b.z) * 0.5;
  p.z = ((s.z + q.x * b.y) - q.y * b.x) * 0.5;
}

}  // namespace

extern "C" void POLHODE_ENTRY(polhode_bench_heun_)(double* states, int paths, int steps, const heun_constants* given) {
  const heun_constants c = *given;
  for (int first = 0; first < paths; first += in_flight * lane_count) {
    triple p[in_flight];
    double* at = states + first;
    for (int k = 0; k < in_flight; ++k, at += lane_count) {
      __builtin_memcpy(&p[k].x, at, sizeof(lanes));
      __builtin_memcpy(&p[k].y, at + paths, sizeof(lanes));
      __builtin_memcpy(&p[k].z, at + 2 * paths, sizeof(lanes));
    }
    for (int i = 0; i < steps; ++i)
#pragma GCC unroll 8
      for (int k = 0; k < in_flight; ++k) step(p[k], c);
    at = states + first;
    for (int k = 0; k < in_flight; ++k, at += lane_count) {
      __builtin_memcpy(at, &p[k].x, sizeof(lanes));
      __builtin_memcpy(at + paths, &p[k].y, sizeof(lanes));
      __builtin_memcpy(at + 2 * paths, &p[k].z, sizeof(lanes));
    }
  }
}
