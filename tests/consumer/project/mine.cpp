// SPDX-License-Identifier: Apache-2.0
// A stranger's integrator: Euler's method for the free rigid body. Its Casimir drifts with order one.
#include <polhode/abi.h>

namespace {

int open(const polhode_scene* scene, void** self, char*, size_t) {
  *self = new double(scene->dt);
  return 0;
}

int advance(void* self, const polhode_batch* batch) {
  const double dt = *static_cast<const double*>(self), inertia[3] = {1, 2, 3};
  for (int step = 0; step < batch->steps; ++step)
    for (int p = 0; p < batch->paths; ++p) {
      double pi[3];
      for (int k = 0; k < 3; ++k) pi[k] = batch->states[k * batch->paths + p];
      for (int k = 0; k < 3; ++k) {
        const int a = (k + 1) % 3, b = (k + 2) % 3;
        batch->states[k * batch->paths + p] += pi[a] * pi[b] * (1 / inertia[b] - 1 / inertia[a]) * dt;
      }
    }
  return 0;
}

void close(void* self) { delete static_cast<double*>(self); }

}  // namespace

extern "C" const polhode_integrator* polhode_integrators(uint32_t abi_version, int32_t* count) {
  static polhode_integrator mine{};
  mine.size = sizeof mine;
  mine.name = "my_euler", mine.title = "Euler's method", mine.source = "this file";
  mine.claims.deterministic = 1, mine.claims.casimir_deterministic = 1;
  mine.open = open, mine.advance = advance, mine.close = close;
  *count = 1;
  return abi_version == POLHODE_ABI_VERSION ? &mine : nullptr;
}
