// SPDX-License-Identifier: Apache-2.0
// An outside project, against the installed headers alone: the README's example, and a check that it ran.
#include <cmath>
#include <cstdio>
#include <polhode/integrate.hpp>
#include <polhode/schemes/strang.hpp>
#include <polhode/systems/rigid_body.hpp>

int main() {
  using namespace polhode;
  const rigid_body body({1, 2, 3}, 0.5, rigid_body::isotropic(0.5));
  const auto pi = integrate<strang>(body, {{0.6, 0.48, 0.64}}, 0.01, 200, {.seed = 1});
  std::printf("%.6f %.6f %.6f\n", pi[0], pi[1], pi[2]);
  return std::fabs(dot(pi, pi) - 1) < 1e-13 ? 0 : 1;
}
