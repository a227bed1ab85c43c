// Random scenes in sane ranges, and what the error at a chosen step is when it is measured again.
#pragma once

#include <cmath>
#include <random>

#include "registry/choose.hpp"
#include "registry/verify.hpp"

namespace polhode::test {

inline select_options asking(const std::string& goal, double tolerance) {
  select_options o;
  o.goal = goal;
  o.tolerance = tolerance;
  o.threads = 2;
  return o;
}

inline scene random_scene(std::mt19937_64& random, int number) {
  const auto between = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
  auto s = load_scene("paper");
  s.name = "random" + std::to_string(number);
  s.inertia = {between(0.7, 1.5), between(1.5, 2.5), between(2.5, 4)};
  s.theta = between(0.1, 1);
  const double sigma = between(0.3, 0.8), c = between(0.7, 1.5);
  s.sigma = {{sigma, 0, 0}, {0, sigma, 0}, {0, 0, sigma}};
  for (double& p : s.momentum) p *= c;
  s.horizon = between(1, 3);
  return s;
}

/// The error at the chosen step with another seed and ten times the paths.
inline double measured_again(const scene& s, const select_options& o, const choice& chosen) {
  const auto bound = bind_scene(s);
  const context c{bound, effort::standard, 2, 77};
  const auto goal = make_goal(c, {o.goal, o.observable, s.horizon, o.tolerance});
  for (const auto& who : goal->candidates(bound)) {
    if (who.name != chosen.scheme) continue;
    double square = 0;
    const int seeds = o.goal == "strong" ? 10 : 1;
    for (int i = 0; i < seeds; ++i) square += std::pow(goal->error(who, chosen.dt, 1000 + i).value, 2) / seeds;
    return std::sqrt(square);
  }
  return NAN;
}

}  // namespace polhode::test
