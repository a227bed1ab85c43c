/* Heun's method for the dissipative stochastic rigid body, as a program: polhode verify SCENE --with ./my_heun_process
 *   cc -std=c99 -O2 my_heun_process.c -o my_heun_process
 */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static struct { char begin[4]; int32_t kind, paths, steps, noise, bytes; double dt; } head;
static double inertia[3], theta, sigma[16][3];

/* The numbers of a member of the scene, which has no blanks, row by row; how many there are. */
static int numbers(const char *json, const char *key, double *out, int most) {
  int n = 0, depth = 0;
  if ((json = strstr(json, key)) == NULL) return 0;
  json += strlen(key);
  do {
    if (*json == '[' || *json == ']') depth += *json++ == '[' ? 1 : -1;
    else if (*json == ',') ++json;
    else if (n < most) out[n++] = strtod(json, (char **)&json);
    else return most + 1;
  } while (depth > 0);
  return n;
}

/* Pi x ((Omega + theta Pi x Omega) dt + noise) */
static void increment(const double *p, const double *noise, double *out) {
  const double o[3] = {p[0] / inertia[0], p[1] / inertia[1], p[2] / inertia[2]};
  const double d[3] = {p[1] * o[2] - p[2] * o[1], p[2] * o[0] - p[0] * o[2], p[0] * o[1] - p[1] * o[0]};
  double xi[3];
  for (int k = 0; k < 3; ++k) xi[k] = (o[k] + theta * d[k]) * head.dt + noise[k];
  for (int k = 0; k < 3; ++k) out[k] = p[(k + 1) % 3] * xi[(k + 2) % 3] - p[(k + 2) % 3] * xi[(k + 1) % 3];
}

static void step(double *x, const double *dw, int channels) {
  for (int p = 0; p < head.paths; ++p) {
    double pi[3], noise[3] = {0}, first[3], second[3], ahead[3];
    for (int k = 0; k < 3; ++k) pi[k] = x[k * head.paths + p];
    for (int k = 0; k < 3; ++k) for (int c = 0; c < channels; ++c) noise[k] += sigma[c][k] * dw[c * head.paths + p];
    increment(pi, noise, first);
    for (int k = 0; k < 3; ++k) ahead[k] = pi[k] + first[k];
    increment(ahead, noise, second);
    for (int k = 0; k < 3; ++k) x[k * head.paths + p] = pi[k] + (first[k] + second[k]) / 2;
  }
}

int main(void) {
  int channels = 0;
  puts("{\"polhode\":1,\"name\":\"my_heun\",\"claims\":{\"strong_commuting\":1,\"strong_general\":0.5,\"weak_one_vector\":1,"
       "\"weak_isotropic\":1,\"weak_general\":1,\"deterministic\":2,\"casimir\":1,\"casimir_deterministic\":3}}");
  for (fflush(stdout); fread(&head, sizeof head, 1, stdin) == 1; fflush(stdout)) {
    char *body = calloc((size_t)head.bytes + 1, 1), *why = "";
    if (body == NULL || fread(body, 1, (size_t)head.bytes, stdin) != (size_t)head.bytes) return 1;
    double *x = (double *)body, *dw = x + 3 * head.paths;
    if (head.kind == 1) {
      if (!strstr(body, "\"system\":\"rigid_body\"") || numbers(body, "\"inertia\":", inertia, 3) != 3) why = "no rigid body";
      numbers(body, "\"theta\":", &theta, 1);
      if ((channels = numbers(body, "\"sigma\":", sigma[0], 48) / 3) > 16) why = "more than 16 noise vectors";
      head.bytes = (int32_t)strlen(why);
      fwrite(&head, sizeof head, 1, stdout), fputs(why, stdout);
    } else {
      for (int i = 0; i < head.steps; ++i) step(x, dw + i * channels * head.paths, head.noise ? channels : 0);
      head.bytes = 3 * head.paths * (int32_t)sizeof *x;
      fwrite(&head, sizeof head, 1, stdout), fwrite(x, 1, (size_t)head.bytes, stdout);
    }
    free(body);
  }
  return 0;
}
