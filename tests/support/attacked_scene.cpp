// SPDX-License-Identifier: Apache-2.0
#include "support/attacked_scene.hpp"

#include <fmt/format.h>

#include <cmath>

namespace polhode::test {

std::array<double, 3> inertia_of(const sphere_problem& body) {
  const auto& k = body.quadratic;
  return {1 / k(0, 0), 1 / k(1, 1), 1 / k(2, 2)};
}

std::string words(const attacked_scene& s) {
  const auto i = inertia_of(s.problem);
  const auto& q = s.problem.covariance;
  const double theta = s.problem.damping, c = s.problem.radius;
  return fmt::format(
      "I {:.17g} {:.17g} {:.17g} theta {:.17g} c {:.17g} Q {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} T {:.17g}",
      i[0], i[1], i[2], theta, c, q(0, 0), q(1, 1), q(2, 2), q(0, 1), q(0, 2), q(1, 2), s.time);
}

attacked_scene drawn_scene(std::mt19937_64& random, bool tame) {
  const auto between = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
  const auto power = [&](double a, double b) { return std::pow(10, between(a, b)); };
  const auto one_of = [&](int n) { return std::uniform_int_distribution(0, n - 1)(random); };
  std::array<double, 3> inertia{power(-0.5, 0.5), power(-0.5, 0.5), power(-0.5, 0.5)};
  const auto a = static_cast<std::size_t>(one_of(3)), b = (a + 1) % 3, c = (a + 2) % 3;
  const int shape = one_of(6);
  if (shape == 0) inertia[a] = inertia[b] * (1 + power(-12, -2));  // nearly symmetric
  if (shape == 1) inertia[a] = inertia[b];                         // prolate or oblate
  if (shape == 2) inertia[a] = inertia[b] = inertia[c] * power(-3, 3);
  if (shape == 3) inertia[a] = inertia[b] * (1 + power(-12, -2)), inertia[c] = inertia[b] * (1 + power(-12, -2));
  attacked_scene s{body_on_sphere(inertia, 0, 1, Eigen::Matrix3d::Zero()), {}, 0, false};
  auto& p = s.problem;
  p.radius = tame ? power(-1, 1) : power(-3, 3);
  p.damping = one_of(5) == 0 ? 0 : tame ? power(-2, 0.5) / p.radius : power(-6, 3);
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
