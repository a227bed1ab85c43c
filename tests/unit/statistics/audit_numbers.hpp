// SPDX-License-Identifier: Apache-2.0
// Numbers for an audit of noise, and the moments of areas.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <random>
#include <vector>

#include "statistics/noise/noise_audit.hpp"

namespace polhode::test {

inline constexpr int lanes = noise_audit::lanes, channels = 3, pairs = 3;
inline constexpr double dt = 0.3;

/// [row][channel or pair][lane], in standard deviations of an increment and in dt/2.
using numbers = std::vector<std::array<std::array<double, lanes>, 3>>;

inline numbers drawn(int rows, unsigned seed) {
  std::mt19937_64 bits(seed);
  std::normal_distribution<float> normal;  // of floats, so that single and double precision are given the same
  numbers out(static_cast<std::size_t>(rows));
  for (auto& row : out)
    for (auto& channel : row)
      for (double& x : channel) x = static_cast<double>(normal(bits));
  return out;
}

inline std::vector<double> scaled(const numbers& z, double unit) {
  std::vector<double> out;
  for (const auto& row : z)
    for (const auto& channel : row)
      for (double x : channel) out.push_back(unit * x);
  return out;
}

/// E u^2, E u^4, E u^2 z^2 with a channel of its own, E u^2 u'^2 of areas that share one.
struct moments {
  double square = 1, fourth = 3, own_channel = 1, shared_channel = 1;
};

/// Of a sum of n cells: u = z^T G z' / n with G_ij = sign(j - i), by Wick's theorem in z and z'.
inline moments of_cells(int n) {
  Eigen::MatrixXd g = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) g(i, j) = (j > i) - (j < i);
  const Eigen::MatrixXd q = g * g.transpose() / (n * n);                  // E[u^2 | z] = z^T q z
  const Eigen::MatrixXd mean = Eigen::MatrixXd::Constant(n, n, 1.0 / n);  // the increment's square
  const double quadratic = q.trace() * q.trace() + 2 * (q * q).trace();   // E (z^T q z)^2
  return {q.trace(), 3 * quadratic, q.trace() * mean.trace() + 2 * (q * mean).trace(), quadratic};
}

}  // namespace polhode::test
