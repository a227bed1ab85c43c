/* SPDX-License-Identifier: Apache-2.0 */
/* An integrator of your own behind a C interface, for `polhode verify SCENE --with ./libmine.so`.
 *
 * The equation is dmu = ad*_a(mu) mu dt + sum_i ad*_sigma_i mu o dW^i (Stratonovich), a(mu) = grad h + theta [grad h,
 * mu^#]: docs/model.md gives it for every system. An integrator advances many paths at once through a few steps, either
 * under the increments that it is handed, or under random numbers of its own.
 *
 * A library exports one function, polhode_integrators. All text is UTF-8 and, as all that is returned, stays where it
 * is while the library is loaded. C99; nothing else is needed.
 */
#ifndef POLHODE_ABI_H
#define POLHODE_ABI_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Rises when a member changes its place or its meaning; members that are added at an end do not raise it. */
#define POLHODE_ABI_VERSION 1

/* The scene at one step size. */
typedef struct polhode_scene {
  uint32_t size; /* of this struct in bytes */
  int32_t components, channels;
  double dt, theta;
  const char *name, *system;
  const double* momentum; /* [component]: where paths start */
  const double* sigma;    /* [channel][component]: noise vectors, zero where there is no noise; where noise depends on
                           * the state, parameters say how */
  /* Any key of the scene file, row by row; NULL where the scene has no such key. */
  const double* (*parameter)(const struct polhode_scene*, const char* key, int32_t* rows, int32_t* columns);
  const char* json; /* all of it, as one JSON object */
} polhode_scene;

/* Paths that advance together. Of step i, channel c and path p the increment is dw[(i * channels + c) * paths + p]. */
typedef struct polhode_batch {
  uint32_t size; /* of this struct in bytes */
  int32_t paths, steps;
  double* states;   /* [component][path]: in and out */
  const double* dw; /* [step][channel][path], of variance dt; NULL: no noise */
  const double*
      area; /* [step][pair][path], pairs (0,1), (0,2), ..., (1,2), ...: A^ij = (int W^i dW^j - W^j dW^i) / 2 */
  const uint64_t* seed; /* [step][path], for random numbers of the integrator's own: equal seeds, equal steps */
  const double* time;   /* [step]: where each begins; NULL where the equation does not depend on the time */
  const double* const* variables; /* of the i-th that the integrator draws: [step][number][path] */
} polhode_batch;

/* What `advance` is handed beside the states. */
enum { POLHODE_TAKES_INCREMENTS = 0, POLHODE_TAKES_AREAS = 1, POLHODE_OWN_NUMBERS = 2 };

/* Flags. */
enum {
  POLHODE_IMPLICIT = 1,   /* solves equations in a step */
  POLHODE_ITO = 2,        /* discretises the Ito form */
  POLHODE_ONE_THREAD = 4, /* must not be called by two threads at a time */
  POLHODE_POISSON = 8     /* a step without noise and dissipation is a Poisson map */
};

/* Orders; 0: not claimed, and measured. casimir: the order of its drift, or POLHODE_KEPT. */
#define POLHODE_KEPT (-1.0)
typedef struct polhode_claims {
  double strong_commuting, strong_general; /* noise vectors that commute (one vector); any */
  double weak_one_vector, weak_isotropic, weak_general;
  double deterministic;                  /* order for sigma = 0 */
  double casimir, casimir_deterministic; /* under noise; for sigma = 0 */
} polhode_claims;

/* A kind of random variable that a step needs beside increments and areas, and how many of it. */
typedef struct polhode_variable {
  int32_t kind; /* POLHODE_GAUSSIAN or another; what this version of the laboratory does not draw it refuses by name */
  int32_t numbers;
} polhode_variable;
enum {
  POLHODE_GAUSSIAN = 1,        /* of variance 1 */
  POLHODE_TWO_POINT = 2,       /* 1 and -1, each with probability 1/2 */
  POLHODE_THREE_POINT = 3,     /* 0 with probability 2/3, sqrt(3) and -sqrt(3) with 1/6 each */
  POLHODE_UNIFORM = 4,         /* on [0, 1) */
  POLHODE_SPACE_TIME_AREA = 5, /* int (W^i - (s/dt) W^i(dt)) ds of each channel */
  POLHODE_SECOND_NOISE = 6     /* increments of further Wiener processes, of variance dt */
};

typedef struct polhode_integrator {
  uint32_t size; /* of this struct in bytes */
  int32_t takes;
  uint32_t flags;
  const char* name; /* letters, digits and _, as it is called in reports */
  const char *title, *source;
  polhode_claims claims;
  /* What `advance` and `close` get as self. Returns 0; anything else: cannot, and `why` (of that many bytes) says why.
   */
  int (*open)(const polhode_scene*, void** self, char* why, size_t bytes);
  /* Returns 0; anything else: failed, and the laboratory reports the number. A state that it cannot compute is NaN. */
  int (*advance)(void* self, const polhode_batch*);
  void (*close)(void* self); /* NULL: nothing to do */
  const polhode_variable* draws; /* NULL: none */
  int32_t drawn;                 /* how many entries `draws` has */
} polhode_integrator;

/* All integrators of this library; NULL if it does not know this version of the interface. */
const polhode_integrator* polhode_integrators(uint32_t abi_version, int32_t* count);

#ifdef __cplusplus
}
#endif
#endif
