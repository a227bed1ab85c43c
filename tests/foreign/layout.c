/* SPDX-License-Identifier: Apache-2.0 */
/* The layout of version 1 of the interface, as libraries out there were compiled with it. A change here breaks them: it
 * needs another version, or another member at an end. */
#include <polhode/abi.h>

#define AT(type, member, place) _Static_assert(offsetof(type, member) == (place), #type "." #member " has moved")
#define SIZE(type, bytes) _Static_assert(sizeof(type) == (bytes), #type " has another size")

#if UINTPTR_MAX == 0xFFFFFFFFFFFFFFFFu
_Static_assert(POLHODE_ABI_VERSION == 1, "state the layout of that version, too");
SIZE(polhode_scene, 80);
AT(polhode_scene, size, 0);
AT(polhode_scene, components, 4);
AT(polhode_scene, channels, 8);
AT(polhode_scene, dt, 16);
AT(polhode_scene, theta, 24);
AT(polhode_scene, name, 32);
AT(polhode_scene, system, 40);
AT(polhode_scene, momentum, 48);
AT(polhode_scene, sigma, 56);
AT(polhode_scene, parameter, 64);
AT(polhode_scene, json, 72);
SIZE(polhode_batch, 64);
AT(polhode_batch, paths, 4);
AT(polhode_batch, steps, 8);
AT(polhode_batch, states, 16);
AT(polhode_batch, dw, 24);
AT(polhode_batch, area, 32);
AT(polhode_batch, seed, 40);
AT(polhode_batch, time, 48);
AT(polhode_batch, variables, 56);
SIZE(polhode_claims, 64);
AT(polhode_claims, weak_one_vector, 16);
AT(polhode_claims, deterministic, 40);
AT(polhode_claims, casimir_deterministic, 56);
SIZE(polhode_variable, 8);
AT(polhode_variable, numbers, 4);
SIZE(polhode_integrator, 144);
AT(polhode_integrator, takes, 4);
AT(polhode_integrator, flags, 8);
AT(polhode_integrator, name, 16);
AT(polhode_integrator, title, 24);
AT(polhode_integrator, source, 32);
AT(polhode_integrator, claims, 40);
AT(polhode_integrator, open, 104);
AT(polhode_integrator, advance, 112);
AT(polhode_integrator, close, 120);
AT(polhode_integrator, draws, 128);
AT(polhode_integrator, drawn, 136);
_Static_assert(POLHODE_TAKES_INCREMENTS == 0 && POLHODE_TAKES_AREAS == 1 && POLHODE_OWN_NUMBERS == 2, "another meaning");
_Static_assert(POLHODE_IMPLICIT == 1 && POLHODE_ITO == 2 && POLHODE_ONE_THREAD == 4 && POLHODE_POISSON == 8, "another meaning");
_Static_assert(POLHODE_GAUSSIAN == 1 && POLHODE_TWO_POINT == 2 && POLHODE_THREE_POINT == 3 && POLHODE_UNIFORM == 4, "another meaning");
_Static_assert(POLHODE_SPACE_TIME_AREA == 5 && POLHODE_SECOND_NOISE == 6, "another meaning");
#endif
