// Random and extreme scenes for the attack on the references.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <random>
#include <string>

#include "references/kolmogorov.hpp"

namespace polhode::test {

struct attacked_scene {
  sphere_problem problem;
  Eigen::Vector3d start;
  double time;
  bool isotropic;
};

inline std::string words(const attacked_scene& s) {
  const auto& [i, theta, c, q] = s.problem;
  return fmt::format(
      "I {:.17g} {:.17g} {:.17g} theta {:.17g} c {:.17g} Q {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} T {:.17g}",
      i[0], i[1], i[2], theta, c, q(0, 0), q(1, 1), q(2, 2), q(0, 1), q(0, 2), q(1, 2), s.time);
}

/// tame: noise, dissipation and shear of about one size, so that most is answered. Else theta and noise from 1e-6 to
/// 1e3, radius from 1e-3 to 1e3, time from 1e-6 to 1e9.
inline attacked_scene drawn_scene(std::mt19937_64& random, bool tame) {
  const auto between = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
  const auto power = [&](double a, double b) { return std::pow(10, between(a, b)); };
  const auto one_of = [&](int n) { return std::uniform_int_distribution(0, n - 1)(random); };
  attacked_scene s{{{power(-0.5, 0.5), power(-0.5, 0.5), power(-0.5, 0.5)}, 0, 1, {}}, {}, 0, false};
  auto& p = s.problem;
  const auto a = static_cast<std::size_t>(one_of(3)), b = (a + 1) % 3, c = (a + 2) % 3;
  const int shape = one_of(6);
  if (shape == 0) p.inertia[a] = p.inertia[b] * (1 + power(-12, -2));  // nearly symmetric
  if (shape == 1) p.inertia[a] = p.inertia[b];                         // prolate or oblate
  if (shape == 2) p.inertia[a] = p.inertia[b] = p.inertia[c] * power(-3, 3);
  if (shape == 3)
    p.inertia[a] = p.inertia[b] * (1 + power(-12, -2)), p.inertia[c] = p.inertia[b] * (1 + power(-12, -2));
  p.radius = tame ? power(-1, 1) : power(-3, 3);
  p.theta = one_of(5) == 0 ? 0 : tame ? power(-2, 0.5) / p.radius : power(-6, 3);
  const double sigma = tame ? std::sqrt(p.radius) * power(-1.2, 0.5) : power(-6, 3);
  const int noise = one_of(5);
  s.isotropic = noise <= 1;
  Eigen::Matrix3d root = sigma * Eigen::Matrix3d::Identity();
  if (noise == 2) root.diagonal() *= between(0.3, 1), root(long(a), long(a)) *= power(-2, 0);
  if (noise == 3) root = sigma * Eigen::Matrix3d::NullaryExpr([&](Eigen::Index) { return between(-1, 1); });
  if (noise == 4)
    root.leftCols(2).setZero(), root.col(2) = sigma * Eigen::Vector3d(between(-1, 1), between(-1, 1), between(-1, 1));
  if (noise == 4 && one_of(2) == 0) root.col(2) = sigma * Eigen::Vector3d::Unit(one_of(3));
  p.covariance = root * root.transpose();
  s.start = p.radius * Eigen::Vector3d(between(-1, 1), between(-1, 1), between(-1, 1)).normalized();
  s.time = tame ? power(-2, 2) / p.radius : power(-6, 9);
  return s;
}

}  // namespace polhode::test
