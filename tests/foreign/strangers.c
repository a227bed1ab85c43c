/* SPDX-License-Identifier: Apache-2.0 */
/* Integrators as strangers would write them, through the C interface alone: four of ours anew, planted defects, and
 * libraries that misbehave. */
#include <polhode/abi.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { most_channels = 16 };
typedef struct body {
  double inertia[3], theta, dt, sigma[most_channels][3];
  int channels;
} body;

static void cross(const double *a, const double *b, double *out) {
  const double x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2], z = a[0] * b[1] - a[1] * b[0];
  out[0] = x, out[1] = y, out[2] = z;
}
static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* a dt + noise, a = Omega + theta Pi x Omega */
static void generator(const body *b, const double *pi, const double *noise, double *out) {
  double omega[3], damping[3];
  for (int k = 0; k < 3; ++k) omega[k] = pi[k] / b->inertia[k];
  cross(pi, omega, damping);
  for (int k = 0; k < 3; ++k) out[k] = (omega[k] + b->theta * damping[k]) * b->dt + noise[k];
}

/* The solution of pi' = pi x xi after time one: Rodrigues. */
static void turn(const double *xi, double *pi) {
  const double angle = sqrt(dot(xi, xi));
  double once[3], twice[3];
  cross(pi, xi, once);
  cross(once, xi, twice);
  const double s = angle < 1e-4 ? 1 - angle * angle / 6 : sin(angle) / angle;
  const double half = angle < 1e-4 ? 0.5 - angle * angle / 24 : (1 - cos(angle)) / (angle * angle);
  for (int k = 0; k < 3; ++k) pi[k] += s * once[k] + half * twice[k];
}

static void heun(const body *b, double *pi, const double *noise, const double *area) {
  double xi[3], first[3], ahead[3], second[3];
  generator(b, pi, noise, xi);
  cross(pi, xi, first);
  for (int k = 0; k < 3; ++k) ahead[k] = pi[k] + first[k];
  generator(b, ahead, noise, xi);
  cross(ahead, xi, second);
  for (int k = 0; k < 3; ++k) pi[k] += (first[k] + second[k]) / 2;
  (void)area;
}

static void magnus(const body *b, double *pi, const double *noise, const double *area) {
  double first[3], ahead[3], second[3], xi[3];
  generator(b, pi, noise, first);
  memcpy(ahead, pi, sizeof ahead);
  turn(first, ahead);
  generator(b, ahead, noise, second);
  for (int k = 0; k < 3; ++k) xi[k] = (first[k] + second[k]) / 2 + area[k];
  turn(xi, pi);
}
static const double no_area[3] = {0, 0, 0};
static void lie_heun(const body *b, double *pi, const double *noise, const double *area) {
  magnus(b, pi, noise, no_area);
  (void)area;
}

static void about_axis(const body *b, int axis, double t, double *pi) {
  const int next = (axis + 1) % 3, last = (axis + 2) % 3;
  const double angle = t * pi[axis] / b->inertia[axis], s = sin(angle), c = cos(angle), x = pi[next], y = pi[last];
  pi[next] = x * c + y * s;
  pi[last] = y * c - x * s;
}
static void free_flow(const body *b, double t, double *pi) {
  about_axis(b, 0, t / 2, pi);
  about_axis(b, 1, t / 2, pi);
  about_axis(b, 2, t, pi);
  about_axis(b, 1, t / 2, pi);
  about_axis(b, 0, t / 2, pi);
}
static void dissipation_flow(const body *b, double t, double *pi) {
  const double square = dot(pi, pi);
  for (int k = 0; k < 3; ++k) pi[k] *= exp(-b->theta * square * t / b->inertia[k]);
  const double factor = sqrt(square / dot(pi, pi));
  for (int k = 0; k < 3; ++k) pi[k] *= factor;
}
/* Noise that is isotropic, or one vector: then it needs no change. */
static void strang_weak2(const body *b, double *pi, const double *noise, const double *area) {
  const double strength = b->channels == 3 && b->sigma[1][1] == b->sigma[0][0] ? b->sigma[0][0] : 0,
               factor = sqrt(1 - strength * strength * b->dt / 12);
  double smaller[3];
  for (int k = 0; k < 3; ++k) smaller[k] = factor * noise[k];
  dissipation_flow(b, b->dt / 2, pi);
  free_flow(b, b->dt / 2, pi);
  turn(smaller, pi);
  free_flow(b, b->dt / 2, pi);
  dissipation_flow(b, b->dt / 2, pi);
  (void)area;
}

/* Defects. */
static void loud(const body *b, double *pi, const double *noise, const double *area) {
  double louder[3];
  for (int k = 0; k < 3; ++k) louder[k] = sqrt(2.0) * noise[k];
  lie_heun(b, pi, louder, area);
}
static void wrong_sign(const body *b, double *pi, const double *noise, const double *area) {
  const double turned[3] = {-area[0], -area[1], -area[2]};
  magnus(b, pi, noise, turned);
}
static void euler_for_stratonovich(const body *b, double *pi, const double *noise, const double *area) {
  double xi[3], change[3];
  generator(b, pi, noise, xi);
  cross(pi, xi, change);
  for (int k = 0; k < 3; ++k) pi[k] += change[k];
  (void)area;
}
static void leaking(const body *b, double *pi, const double *noise, const double *area) {
  lie_heun(b, pi, noise, area);
  for (int k = 0; k < 3; ++k) pi[k] *= 1 - 1e-6;
}
static void not_a_number(const body *b, double *pi, const double *noise, const double *area) {
  lie_heun(b, pi, noise, area);
  if (b->dt < 0.1) pi[1] = NAN;
}
static int calls;
static void forgetful(const body *b, double *pi, const double *noise, const double *area) {
  lie_heun(b, pi, noise, area);
  pi[0] += 1e-9 * (double)(++calls % 7);
}
static volatile double shared_state[3];
static void in_one_place(const body *b, double *pi, const double *noise, const double *area) {
  for (int k = 0; k < 3; ++k) shared_state[k] = pi[k];
  for (volatile int wait = 0; wait < 2000; ++wait) continue;
  for (int k = 0; k < 3; ++k) pi[k] = shared_state[k];
  lie_heun(b, pi, noise, area);
}
static void ends_the_program(const body *b, double *pi, const double *noise, const double *area) {
  (void)b, (void)pi, (void)noise, (void)area;
  exit(3);
}
static void aborts(const body *b, double *pi, const double *noise, const double *area) {
  (void)b, (void)pi, (void)noise, (void)area;
  abort();
}

typedef void (*step)(const body *, double *, const double *, const double *);
typedef struct stepper {
  body b;
  step one;
} stepper;

static int open_body(const polhode_scene *s, void **self, char *why, size_t bytes, step one) {
  int32_t rows, columns;
  const double *inertia = s->parameter(s, "inertia", &rows, &columns);
  if (s->components != 3 || inertia == NULL || s->channels > most_channels) {
    snprintf(why, bytes, "knows rigid bodies alone, not %s of %d components", s->system, (int)s->components);
    return 1;
  }
  stepper *st = calloc(1, sizeof *st);
  if (st == NULL) return 2;
  memcpy(st->b.inertia, inertia, sizeof st->b.inertia);
  memcpy(st->b.sigma, s->sigma, sizeof(double) * 3 * (size_t)s->channels);
  st->b.theta = s->theta;
  st->b.dt = s->dt;
  st->b.channels = s->channels;
  st->one = one;
  *self = st;
  return 0;
}

static int advance(void *self, const polhode_batch *batch) {
  const stepper *st = self;
  const body *b = &st->b;
  const int paths = batch->paths, pairs = b->channels * (b->channels - 1) / 2;
  for (int i = 0; i < batch->steps; ++i)
    for (int p = 0; p < paths; ++p) {
      double pi[3], noise[3] = {0, 0, 0}, area[3] = {0, 0, 0};
      for (int k = 0; k < 3; ++k) pi[k] = batch->states[k * paths + p];
      for (int c = 0; c < b->channels && batch->dw != NULL; ++c)
        for (int k = 0; k < 3; ++k) noise[k] += b->sigma[c][k] * batch->dw[(i * b->channels + c) * paths + p];
      for (int c = 0, pair = 0; c < b->channels && batch->area != NULL; ++c)
        for (int d = c + 1; d < b->channels; ++d, ++pair) {
          double bracket[3];
          cross(b->sigma[c], b->sigma[d], bracket);
          for (int k = 0; k < 3; ++k) area[k] += bracket[k] * batch->area[(i * pairs + pair) * paths + p];
        }
      st->one(b, pi, noise, area);
      for (int k = 0; k < 3; ++k) batch->states[k * paths + p] = pi[k];
    }
  return 0;
}

/* Normals of its own: Box and Muller over a generator by Vigna (SplitMix64). */
static double uniform(uint64_t *state) {
  uint64_t x = (*state += 0x9E3779B97F4A7C15u);
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
  return ((double)((x ^ (x >> 31)) >> 11) + 0.5) / 9007199254740992.0;
}
static int advance_with_noise(void *self, const polhode_batch *batch, double strength) {
  const stepper *st = self;
  const body *b = &st->b;
  const int paths = batch->paths;
  for (int i = 0; i < batch->steps; ++i)
    for (int p = 0; p < paths; ++p) {
      uint64_t state = batch->seed[i * paths + p];
      double pi[3], noise[3] = {0, 0, 0};
      for (int k = 0; k < 3; ++k) pi[k] = batch->states[k * paths + p];
      for (int c = 0; c < b->channels; ++c) {
        const double radius = sqrt(-2 * log(uniform(&state))), angle = 6.283185307179586 * uniform(&state);
        for (int k = 0; k < 3; ++k)
          noise[k] += b->sigma[c][k] * strength * sqrt(b->dt) * radius * cos(angle);
      }
      st->one(b, pi, noise, NULL);
      for (int k = 0; k < 3; ++k) batch->states[k * paths + p] = pi[k];
    }
  return 0;
}
static int advance_by_own_numbers(void *self, const polhode_batch *batch) { return advance_with_noise(self, batch, 1); }
static int advance_too_loud(void *self, const polhode_batch *batch) { return advance_with_noise(self, batch, sqrt(2.0)); }

static int advance_and_write_on(void *self, const polhode_batch *batch) {
  batch->states[3 * batch->paths] = 1;
  return advance(self, batch);
}
static int advance_and_write_before(void *self, const polhode_batch *batch) {
  batch->states[-1] = 1;
  return advance(self, batch);
}
static int advance_and_fail(void *self, const polhode_batch *batch) {
  (void)self, (void)batch;
  return 7;
}

#define OPENED_BY(one)                                                                                \
  static int open_##one(const polhode_scene *s, void **self, char *why, size_t bytes) {               \
    return open_body(s, self, why, bytes, one);                                                       \
  }
OPENED_BY(heun)
OPENED_BY(magnus)
OPENED_BY(lie_heun)
OPENED_BY(strang_weak2)
OPENED_BY(loud)
OPENED_BY(wrong_sign)
OPENED_BY(euler_for_stratonovich)
OPENED_BY(leaking)
OPENED_BY(not_a_number)
OPENED_BY(forgetful)
OPENED_BY(in_one_place)
OPENED_BY(ends_the_program)
OPENED_BY(aborts)

#define CLAIMS(strong, weak, casimir)  {1, strong, weak, weak, weak, 2, casimir, casimir == POLHODE_KEPT ? 0 : 3}
#define KEEPING CLAIMS(0.5, 1, POLHODE_KEPT)
#define INTEGRATOR(name, takes, flags, claims, open, advance) \
  { sizeof(polhode_integrator), takes, flags, name, NULL, NULL, claims, open, advance, free, NULL, 0 }
#define OVERCLAIMED {0, 1, 0, 0, 0, 2, POLHODE_KEPT, 0}
#define UNCLAIMED {0, 0, 0, 0, 0, 0, 0, 0}

static const polhode_integrator all[] = {
    INTEGRATOR("c_heun", POLHODE_TAKES_INCREMENTS, 0, CLAIMS(0.5, 1, 1), open_heun, advance),
    INTEGRATOR("c_lie_heun", POLHODE_TAKES_INCREMENTS, 0, KEEPING, open_lie_heun, advance),
    INTEGRATOR("c_magnus", POLHODE_TAKES_AREAS, 0, CLAIMS(1, 1, POLHODE_KEPT), open_magnus, advance),
    INTEGRATOR("c_strang_weak2", POLHODE_TAKES_INCREMENTS, POLHODE_POISSON, CLAIMS(0.5, 2, POLHODE_KEPT),
               open_strang_weak2, advance),
    INTEGRATOR("unclaimed_heun", POLHODE_TAKES_INCREMENTS, 0, UNCLAIMED, open_heun, advance),
    INTEGRATOR("unclaimed_magnus", POLHODE_TAKES_AREAS, 0, UNCLAIMED, open_magnus, advance),
    /* claims too much under noise of this class, and nothing for another */
    INTEGRATOR("half_claimed", POLHODE_TAKES_INCREMENTS, 0, OVERCLAIMED, open_lie_heun, advance),
    INTEGRATOR("own_lie_heun", POLHODE_OWN_NUMBERS, 0, KEEPING, open_lie_heun, advance_by_own_numbers),
    INTEGRATOR("own_but_loud", POLHODE_OWN_NUMBERS, 0, KEEPING, open_lie_heun, advance_too_loud),
    INTEGRATOR("loud", POLHODE_TAKES_INCREMENTS, 0, KEEPING, open_loud, advance),
    INTEGRATOR("wrong_area_sign", POLHODE_TAKES_AREAS, 0, CLAIMS(1, 1, POLHODE_KEPT), open_wrong_sign, advance),
    INTEGRATOR("euler", POLHODE_TAKES_INCREMENTS, 0, CLAIMS(0.5, 1, 1), open_euler_for_stratonovich, advance),
    INTEGRATOR("leaking", POLHODE_TAKES_INCREMENTS, 0, KEEPING, open_leaking, advance),
    INTEGRATOR("not_a_number", POLHODE_TAKES_INCREMENTS, 0, KEEPING, open_not_a_number, advance),
    INTEGRATOR("forgetful", POLHODE_TAKES_INCREMENTS, 0, KEEPING, open_forgetful, advance),
    INTEGRATOR("in_one_place", POLHODE_TAKES_INCREMENTS, 0, KEEPING, open_in_one_place, advance),
    INTEGRATOR("ends_the_program", POLHODE_TAKES_INCREMENTS, 0, KEEPING, open_ends_the_program, advance),
    INTEGRATOR("aborts", POLHODE_TAKES_INCREMENTS, 0, KEEPING, open_aborts, advance),
    INTEGRATOR("writes_on", POLHODE_TAKES_INCREMENTS, 0, KEEPING, open_lie_heun, advance_and_write_on),
    INTEGRATOR("writes_before", POLHODE_TAKES_INCREMENTS, 0, KEEPING, open_lie_heun, advance_and_write_before),
    INTEGRATOR("fails", POLHODE_TAKES_INCREMENTS, 0, KEEPING, open_lie_heun, advance_and_fail),
};

const polhode_integrator *polhode_integrators(uint32_t abi_version, int32_t *count) {
  *count = (int32_t)(sizeof all / sizeof *all);
  return abi_version == POLHODE_ABI_VERSION ? all : NULL;
}
