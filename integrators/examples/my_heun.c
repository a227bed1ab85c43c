/* SPDX-License-Identifier: Apache-2.0 */
/* Heun's method for the dissipative stochastic rigid body, as a library for `polhode verify SCENE --with ./my_heun.so`:
 *   cc -std=c99 -O2 -shared -fPIC -I<prefix>/include my_heun.c -o my_heun.so
 */
#include <polhode/abi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct body {
  double inertia[3], theta, dt;
  int channels;
  double sigma[16][3];
} body;

static void cross(const double *a, const double *b, double *out) {
  out[0] = a[1] * b[2] - a[2] * b[1];
  out[1] = a[2] * b[0] - a[0] * b[2];
  out[2] = a[0] * b[1] - a[1] * b[0];
}

/* Pi x (Omega + theta Pi x Omega) dt + Pi x sum sigma_i dW^i */
static void slope(const body *b, const double *pi, const double *noise, double *out) {
  double omega[3], damping[3], xi[3];
  for (int k = 0; k < 3; ++k) omega[k] = pi[k] / b->inertia[k];
  cross(pi, omega, damping);
  for (int k = 0; k < 3; ++k) xi[k] = (omega[k] + b->theta * damping[k]) * b->dt + noise[k];
  cross(pi, xi, out);
}

static int open_body(const polhode_scene *scene, void **self, char *why, size_t bytes) {
  int32_t rows, columns;
  const double *inertia = scene->parameter(scene, "inertia", &rows, &columns);
  if (strcmp(scene->system, "rigid_body") != 0 || inertia == NULL || scene->channels > 16) {
    snprintf(why, bytes, "my_heun knows rigid bodies with up to 16 noise vectors");
    return 1;
  }
  body *b = calloc(1, sizeof *b);
  if (b == NULL) return 2;
  memcpy(b->inertia, inertia, sizeof b->inertia);
  b->theta = scene->theta;
  b->dt = scene->dt;
  b->channels = scene->channels;
  memcpy(b->sigma, scene->sigma, sizeof(double) * 3 * (size_t)scene->channels);
  *self = b;
  return 0;
}

static int advance(void *self, const polhode_batch *batch) {
  const body *b = self;
  const int paths = batch->paths;
  for (int i = 0; i < batch->steps; ++i)
    for (int p = 0; p < paths; ++p) {
      double pi[3], noise[3] = {0, 0, 0}, first[3], ahead[3], second[3];
      for (int c = 0; c < b->channels && batch->dw != NULL; ++c)
        for (int k = 0; k < 3; ++k) noise[k] += b->sigma[c][k] * batch->dw[(i * b->channels + c) * paths + p];
      for (int k = 0; k < 3; ++k) pi[k] = batch->states[k * paths + p];
      slope(b, pi, noise, first);
      for (int k = 0; k < 3; ++k) ahead[k] = pi[k] + first[k];
      slope(b, ahead, noise, second);
      for (int k = 0; k < 3; ++k) batch->states[k * paths + p] = pi[k] + (first[k] + second[k]) / 2;
    }
  return 0;
}

static const polhode_integrator mine = {
    .size = sizeof(polhode_integrator),
    .takes = POLHODE_TAKES_INCREMENTS,
    .name = "my_heun",
    .title = "Heun's method in C",
    .claims = {.strong_commuting = 1, .strong_general = 0.5, .weak_one_vector = 1, .weak_isotropic = 1,
               .weak_general = 1, .deterministic = 2, .casimir = 1, .casimir_deterministic = 3},
    .open = open_body,
    .advance = advance,
    .close = free,
};

const polhode_integrator *polhode_integrators(uint32_t abi_version, int32_t *count) {
  *count = 1;
  return abi_version == POLHODE_ABI_VERSION ? &mine : NULL;
}
