/* SPDX-License-Identifier: Apache-2.0 */
/* Heun's method for the dissipative stochastic rigid body: cc -std=c99 -O3 my_heun_process.c -o my_heun_process */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#define EACH(k, n) for (int k = 0; k < (n); ++k)
#define CROSS(a, b, k) (a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3])
static struct { char begin[4]; int32_t kind, paths, steps, noise, bytes; double dt; } head;
static union { char text[1 << 21]; double x[1 << 18]; } body;
static double inertia[3], theta, channels, sigma[16][3];
static void numbers(const char *key, double *out, int count) { /* of a key of the scene, row by row */
  for (char *at = strstr(body.text, key) + strlen(key); count-- > 0;) *out++ = strtod(at += strspn(at, "[],"), &at);
}
static void step(double *x, const double *dw, int n) { /* one path of n: Pi x ((Omega + theta Pi x Omega) dt + noise) */
  double pi[3], omega[3], xi[3], slope[2][3], noise[3] = {0};
  EACH(c, head.noise ? channels : 0) EACH(k, 3) noise[k] += sigma[c][k] * dw[c * n];
  EACH(k, 3) pi[k] = x[k * n];
  EACH(i, 2) {
    EACH(k, 3) omega[k] = pi[k] / inertia[k];
    EACH(k, 3) xi[k] = (omega[k] + theta * CROSS(pi, omega, k)) * head.dt + noise[k];
    EACH(k, 3) slope[i][k] = CROSS(pi, xi, k);
    EACH(k, 3) pi[k] += slope[i][k];
  }
  EACH(k, 3) x[k * n] += (slope[0][k] + slope[1][k]) / 2;
}
int main(void) {
  puts("{\"polhode\":1,\"name\":\"my_heun\",\"claims\":{\"strong_commuting\":1,\"strong_general\":0.5,\"weak_one_vector\":1,"
       "\"weak_isotropic\":1,\"weak_general\":1,\"deterministic\":2,\"casimir\":1,\"casimir_deterministic\":3}}");
  while (fflush(stdout) == 0 && fread(&head, sizeof head, 1, stdin) == 1) {
    const size_t got = head.bytes < (int)sizeof body ? fread(body.text, 1, head.bytes, stdin) : 0, n = head.paths;
    if (got == (size_t)head.bytes) body.text[got] = 0; else return 1;
    const char *why = head.kind == 1 && !strstr(body.text, "\"rigid_body\"") ? "my_heun knows rigid bodies alone" : "";
    if (head.kind == 1 && !*why) numbers("\"channels\":", &channels, 1), numbers("\"theta\":", &theta, 1),
                                 numbers("\"inertia\":", inertia, 3), numbers("\"sigma\":", sigma[0], 3 * channels);
    EACH(i, head.steps) EACH(p, (int)n) step(body.x + p, body.x + (3 + i * (int)channels) * n + p, n);
    head.bytes = head.kind == 1 ? strlen(why) : 3 * n * sizeof(double);
    fwrite(&head, sizeof head, 1, stdout), fwrite(head.kind == 1 ? why : body.text, 1, head.bytes, stdout);
  }
}
