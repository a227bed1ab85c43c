// SPDX-License-Identifier: Apache-2.0
// What a programmer writes first: Eigen, std::normal_distribution, one path at a time.
#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "bench/yardsticks.hpp"

namespace polhode::bench {
namespace {

using vector = Eigen::Vector3d;

constexpr double theta = 0.5, sigma = 0.5;
const vector inverse_inertia(1.0, 1.0 / 2, 1.0 / 3);

vector generator(const vector& p) {
  const vector omega = inverse_inertia.cwiseProduct(p);
  return omega + theta * p.cross(omega);
}

/// The rotation of p by -v.
vector rotated(const vector& v, const vector& p) {
  const double angle = v.norm();
  if (angle < 1e-14) return p;
  return Eigen::AngleAxisd(-angle, v / angle) * p;
}

vector heun_step(const vector& p, const vector& noise, double dt) {
  const vector first = p.cross(generator(p) * dt + noise), predicted = p + first;
  return p + 0.5 * (first + predicted.cross(generator(predicted) * dt + noise));
}

vector lie_heun_step(const vector& p, const vector& noise, double dt) {
  const vector first = generator(p) * dt + noise;
  const vector second = generator(rotated(first, p)) * dt + noise;
  return rotated(0.5 * (first + second), p);
}

void turn(vector& p, int axis, double t) {
  const int next = (axis + 1) % 3, last = (axis + 2) % 3;
  const double angle = t * p[axis] * inverse_inertia[axis], c = std::cos(angle), s = std::sin(angle);
  const double a = p[next] * c + p[last] * s;
  p[last] = p[last] * c - p[next] * s;
  p[next] = a;
}

void dissipate(vector& p, double t) {
  const vector y = (p.array() * (-theta * t * p.squaredNorm() * inverse_inertia.array()).exp()).matrix();
  p = y * (p.norm() / y.norm());
}

vector free_flow(vector p, double t) {
  turn(p, 0, t / 2);
  turn(p, 1, t / 2);
  turn(p, 2, t);
  turn(p, 1, t / 2);
  turn(p, 0, t / 2);
  return p;
}

/// D(dt/2) N D(dt/2) F(dt): the palindrome F(dt/2) D N D F(dt/2) with its halves of F joined, the cheapest order there
/// is. Half of F is missing before the first step and too much after the last one.
vector strang_step(vector p, const vector& noise, double dt) {
  dissipate(p, dt / 2);
  p = rotated(noise, p);
  dissipate(p, dt / 2);
  return free_flow(p, dt);
}

template <class Step>
vector walk(Step step, ensemble_noise noise, vector p, std::span<const double> common, int steps, double dt) {
  static std::mt19937_64 generator(1);
  static std::normal_distribution<double> normal;
  const double root = std::sqrt(dt);
  for (int i = 0; i < steps; ++i) {
    vector w = vector::Zero();
    if (noise == ensemble_noise::common) w = Eigen::Map<const vector>(common.data() + 3 * i);
    if (noise == ensemble_noise::independent)
      w = root * vector(normal(generator), normal(generator), normal(generator));
    p = step(p, sigma * w, dt);
  }
  return p;
}

}  // namespace

momentum eigen_std(yard_scheme scheme, ensemble_noise noise, momentum start, std::span<const double> common, int steps,
                   double dt) {
  vector p(start[0], start[1], start[2]);
  const auto through = [&](auto step) { p = walk(step, noise, p, common, steps, dt); };
  if (scheme == yard_scheme::heun) through(heun_step);
  if (scheme == yard_scheme::lie_heun) through(lie_heun_step);
  if (scheme == yard_scheme::strang) {
    p = free_flow(p, dt / 2);
    through(strang_step);
    p = free_flow(p, -dt / 2);
  }
  return {p[0], p[1], p[2]};
}

}  // namespace polhode::bench
