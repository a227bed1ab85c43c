/* SPDX-License-Identifier: Apache-2.0 */
/* One of strangers.c as a process: the same steps through the other door.   usage: as_process NAME */
#include <polhode/abi.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static struct {
  char begin[4];
  int32_t kind, paths, steps, noise, bytes;
  double dt;
} head;
static char *body;
static double inertia[3], sigma[16 * 3], counts[2];
static polhode_scene scene;

/* Numbers of a key of the scene, row by row. */
static void numbers(const char *key, double *out, int count) {
  char *at = strstr(body, key);
  if (at == NULL) exit(2);
  for (at += strlen(key); count-- > 0;) *out++ = strtod(at += strspn(at, "[],"), &at);
}
static const double *parameter(const polhode_scene *s, const char *key, int32_t *rows, int32_t *columns) {
  (void)s;
  *rows = 1, *columns = 3;
  return strcmp(key, "inertia") == 0 ? inertia : NULL;
}
static void read_scene(void) {
  if (strstr(body, "\"rigid_body\"") == NULL) exit(2);
  numbers("\"components\":", counts, 1), numbers("\"channels\":", counts + 1, 1);
  numbers("\"theta\":", &scene.theta, 1), numbers("\"inertia\":", inertia, 3);
  numbers("\"sigma\":", sigma, 3 * (int)counts[1]);
  scene.size = sizeof scene, scene.system = "rigid_body", scene.sigma = sigma, scene.parameter = parameter;
  scene.components = (int32_t)counts[0], scene.channels = (int32_t)counts[1];
}

static void greet(const polhode_integrator *one) {
  static const char *const takes[] = {"increments", "areas", "own numbers"};
  const polhode_claims *c = &one->claims;
  printf("{\"polhode\":1,\"name\":\"p%s\",\"takes\":\"%s\",\"poisson\":%s,\"claims\":{\"strong_commuting\":%g,"
         "\"strong_general\":%g,\"weak_one_vector\":%g,\"weak_isotropic\":%g,\"weak_general\":%g,\"deterministic\":%g",
         one->name + 1, takes[one->takes], one->flags & POLHODE_POISSON ? "true" : "false", c->strong_commuting,
         c->strong_general, c->weak_one_vector, c->weak_isotropic, c->weak_general, c->deterministic);
  if (c->casimir == POLHODE_KEPT)
    puts(",\"casimir\":\"kept\"}}");
  else
    printf(",\"casimir\":%g,\"casimir_deterministic\":%g}}\n", c->casimir, c->casimir_deterministic);
}

/* The states behind the steps of a frame, in place. */
static void advance(const polhode_integrator *one) {
  const size_t n = (size_t)head.paths, steps = (size_t)head.steps, channels = (size_t)scene.channels;
  char *noise = body + 3 * n * sizeof(double);
  polhode_batch batch = {sizeof batch, head.paths, head.steps, (double *)body, NULL, NULL, NULL};
  if (head.noise == 1 || head.noise == 2) batch.dw = (const double *)noise;
  if (head.noise == 2) batch.area = (const double *)noise + steps * channels * n;
  if (head.noise == 3) batch.seed = (const uint64_t *)noise;
  void *self;
  char why[256];
  scene.dt = head.dt;
  if (one->open(&scene, &self, why, sizeof why) != 0) exit(3);
  if (one->advance(self, &batch) != 0) exit(4);
  one->close(self);
}

int main(int argc, char **argv) {
  int32_t count;
  const polhode_integrator *all = polhode_integrators(POLHODE_ABI_VERSION, &count), *one = all;
  while (argc == 2 && one < all + count && strcmp(one->name, argv[1]) != 0) ++one;
  if (argc != 2 || one == all + count) return 1;
  greet(one);
  while (fflush(stdout) == 0 && fread(&head, sizeof head, 1, stdin) == 1) {
    const size_t bytes = (size_t)head.bytes;
    body = realloc(body, bytes + 1);
    if (body == NULL || fread(body, 1, bytes, stdin) != bytes) return 2;
    body[bytes] = 0;
    if (head.kind == 1)
      read_scene(), head.bytes = 0;
    else
      advance(one), head.bytes = (int32_t)(3 * sizeof(double)) * head.paths;
    fwrite(&head, sizeof head, 1, stdout), fwrite(body, 1, (size_t)head.bytes, stdout);
  }
  return 0;
}
